#pragma once

#include "app/render/gl_handle.h"
#include "app/view/frame.h"
#include "core/base/result.h"

namespace texplorer::render {

/// Where a renderer draws: an RGBA texture of 8 bits a component and 24 bits of depth, one sample a pixel.
class RenderTarget {
public:
    /// Makes it this size, at least 1 x 1; does nothing where it already is. Leaves the framebuffer bound.
    [[nodiscard]] Result<void> bind(view::Size size);

    [[nodiscard]] GLuint texture() const { return color_.name(); }
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }
    [[nodiscard]] view::Size size() const { return size_; } ///< 0 x 0 before the first bind

private:
    [[nodiscard]] Result<void> resize(view::Size size);

    TextureHandle color_;
    RenderbufferHandle depth_;
    FramebufferHandle framebuffer_;
    view::Size size_;
};

} // namespace texplorer::render
