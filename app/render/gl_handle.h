#pragma once

#include "app/view/picture_handle.h"

#include <GL/glew.h>

#include <utility>

namespace texplorer::render {

/// Owns the name of a GL object: move-only, deletes the object, may be empty. Must be destroyed while its
/// context is current.
template<class Kind>
class GlHandle {
public:
    GlHandle() = default;
    [[nodiscard]] static GlHandle create() {
        GlHandle handle;
        Kind::generate(&handle.name_);
        return handle;
    }

    GlHandle(const GlHandle&) = delete;
    GlHandle& operator=(const GlHandle&) = delete;
    GlHandle(GlHandle&& other) noexcept
        : name_(std::exchange(other.name_, 0)) {}
    GlHandle& operator=(GlHandle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlHandle() {
        if (name_ != 0)
            Kind::destroy(&name_);
    }

    [[nodiscard]] GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

private:
    GLuint name_ = 0;
};

struct TextureKind {
    static void generate(GLuint* name) { glGenTextures(1, name); }
    static void destroy(const GLuint* name) { glDeleteTextures(1, name); }
};
struct BufferKind {
    static void generate(GLuint* name) { glGenBuffers(1, name); }
    static void destroy(const GLuint* name) { glDeleteBuffers(1, name); }
};
struct FramebufferKind {
    static void generate(GLuint* name) { glGenFramebuffers(1, name); }
    static void destroy(const GLuint* name) { glDeleteFramebuffers(1, name); }
};
struct RenderbufferKind {
    static void generate(GLuint* name) { glGenRenderbuffers(1, name); }
    static void destroy(const GLuint* name) { glDeleteRenderbuffers(1, name); }
};

/// A texture as the panels know it.
[[nodiscard]] inline view::PictureHandle handleOf(GLuint texture) {
    return static_cast<view::PictureHandle>(texture);
}

using TextureHandle = GlHandle<TextureKind>;
using BufferHandle = GlHandle<BufferKind>;
using FramebufferHandle = GlHandle<FramebufferKind>;
using RenderbufferHandle = GlHandle<RenderbufferKind>;

} // namespace texplorer::render
