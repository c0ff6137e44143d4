#pragma once

#include "app/render/gl_handle.h"
#include "app/view/frame.h"
#include "texplorer/base/result.h"

namespace texplorer::render {

/// The target of a renderer: an RGBA texture with 8 bits per component and 24 bits of depth, one sample per
/// pixel.
class RenderTarget {
public:
    /// Sets the size, at least 1 x 1; does nothing if it has that size already. Leaves the framebuffer bound.
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
