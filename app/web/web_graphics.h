#pragma once

#include "app/gles/scene_painter.h"
#include "app/stage/picture_cache.h"
#include "app/view/plain_preview.h"
#include "app/web/web_device.h"

#include <array>
#include <optional>

namespace texplorer::web {

/// Draws the window on the page's canvas, and the scene with shaders.
class WebGraphics final : public stage::Graphics {
public:
    WebGraphics();

    [[nodiscard]] const view::Capabilities& capabilities() const override { return capabilities_; }
    [[nodiscard]] const view::OfferedRenderers& renderers() const override { return offered_; }
    [[nodiscard]] Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                                           const ImageSource& images, double time, view::Size size,
                                           LevelsSource& levels) override;
    [[nodiscard]] Result<Image> read(RendererKind renderer, view::Side side) override;
    [[nodiscard]] view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) override {
        return pictures_.show(image, use);
    }
    [[nodiscard]] view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                                  LevelsSource& levels) override {
        return show(preview_.show(texture, images, levels), Use::Enlarged);
    }
    [[nodiscard]] bool isUploading() const override { return false; }
    void endFrame() override { pictures_.endFrame(); }
    void startPanels() override { makeFonts(); }
    void endPanels() override { dropFonts(); }
    void fontsChanged() override;
    [[nodiscard]] bool fetchFont() override;
    void beginFrame() override {}
    void drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) override;
    [[nodiscard]] Image readPanels(view::Size pixels) override;
    [[nodiscard]] ImDrawCallback blendingSwitch() const override;

    /// Call when the page has lost its textures, with the canvas's new context.
    void contextRestored();

private:
    void makeFonts();
    void dropFonts();

    gles::ScenePainter& painterOf(view::Side side);

    view::Capabilities capabilities_;
    view::OfferedRenderers offered_;
    stage::PictureCache pictures_;
    view::PlainPreview preview_;
    WebDevice device_;
    std::array<std::optional<gles::ScenePainter>, 2> painters_; ///< by view::Side
    unsigned fonts_ = 0;                                        ///< the texture
};

} // namespace texplorer::web
