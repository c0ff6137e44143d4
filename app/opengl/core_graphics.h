#pragma once

#include "app/opengl/context_graphics.h"
#include "app/view/plain_preview.h"

namespace texplorer::opengl {

/// Draws the window if the driver has only a core profile, without fixed functions: pictures as RGBA
/// textures, the panels with Dear ImGui's OpenGL3 backend. It has neither of the OpenGL renderers: both keep
/// a texture's base internal format, and a core profile has removed several of them. The reference draws the
/// scene. Belongs to the current context and its thread, and must be destroyed before the context.
class CoreGraphics final : public ContextGraphics {
public:
    CoreGraphics();

    [[nodiscard]] const view::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] const view::OfferedRenderers& renderers() const override { return offered_; }
    [[nodiscard]] Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                                           const ImageSource& images, double time, view::Size size,
                                           LevelsSource& levels) override;
    [[nodiscard]] Result<Image> read(RendererKind renderer, view::Side side) override;
    [[nodiscard]] view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                                  LevelsSource& levels) override;
    [[nodiscard]] bool isUploading() const override { return false; }

private:
    [[nodiscard]] Error lack(RendererKind renderer) const;

    view::Capabilities capabilities_;
    view::OfferedRenderers offered_;
    view::PlainPreview preview_;
};

} // namespace texplorer::opengl
