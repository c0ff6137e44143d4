#pragma once

#include "app/render/gl_errors.h"
#include "app/render/gl_handle.h"
#include "core/image/image.h"
#include "core/scene/scene.h"

#include <optional>
#include <string_view>

namespace texplorer::render {

/// A GL texture object: images that never change, and parameters that follow a Texture of the scene.
class TextureObject {
public:
    TextureObject() = default;

    /// Uploads every level of a chain to a new texture object of 8 bits a component. GL errors are reported
    /// as `where`.
    TextureObject(Target target, BaseFormat format, const MipChain& chain, std::string_view where,
                  GlErrors& errors);

    /// The one place where a Texture becomes glTexParameter calls; none where nothing changed. What GL
    /// refused is reported every time.
    void apply(const Texture& texture, float maxAnisotropy, std::string_view where, GlErrors& errors);

    [[nodiscard]] GLuint name() const { return handle_.name(); }

private:
    TextureHandle handle_;
    GLenum target_ = GL_TEXTURE_2D;
    std::optional<Texture> applied_;
    GlErrors applyErrors_;
};

} // namespace texplorer::render
