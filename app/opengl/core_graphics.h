#pragma once

#include "app/opengl/context_graphics.h"
#include "app/render/preview_picture.h"

#include <memory>
#include <optional>

namespace texplorer::opengl {

/// Paints the window where the driver has a core profile alone, without fixed functions: pictures as RGBA
/// textures, the panels with Dear ImGui's OpenGL3 backend. It has neither of OpenGL's renderers: both keep a
/// texture's base internal format, which a core profile has taken away, so that the reference draws. Belongs
/// to the context that is current, on its thread, and must be destroyed before that.
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
    render::PreviewPicture preview_;
    std::optional<LevelsRequest> previewed_; ///< what `texture_` was made of
    std::shared_ptr<const Image> texture_;   ///< of the preview
};

} // namespace texplorer::opengl
