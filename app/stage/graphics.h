#pragma once

#include "app/view/capabilities.h"
#include "app/view/frame.h"
#include "app/view/offered_renderers.h"
#include "app/view/side.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/renderer.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"
#include "core/texture/levels_source.h"

#include <imgui.h>

#include <memory>

namespace texplorer::stage {

/// What a host lends to its stage: who draws the scene, where pictures are kept so that panels can show them,
/// and who draws the panels.
class Graphics {
public:
    Graphics() = default;
    Graphics(const Graphics&) = delete;
    Graphics& operator=(const Graphics&) = delete;
    virtual ~Graphics() = default;

    /// Of the driver, where there is one.
    [[nodiscard]] virtual const view::Capabilities& capabilities() const = 0;

    /// Those that `draw` has, and the reference, which needs none of this. May change between two frames.
    [[nodiscard]] virtual const view::OfferedRenderers& renderers() const = 0;

    /// Draws the scene with a renderer that is offered; RendererKind::Reference is never asked for. The error
    /// says what it refused. A texture is what it was before until `levels` has it. Each side has pictures
    /// and textures of its own.
    [[nodiscard]] virtual Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                                                   const ImageSource& images, double time, view::Size size,
                                                   LevelsSource& levels) = 0;
    /// What this renderer has drawn last of a side: Rgba8, bottom row first.
    [[nodiscard]] virtual Result<Image> read(RendererKind renderer, view::Side side) = 0;

    enum class Use {
        Scaled,   ///< to any size: filtered linearly
        Enlarged, ///< so that one sees its pixels
    };
    /// A picture of the image, valid until the second `endFrame` from here. An image is used in one way.
    [[nodiscard]] virtual view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) = 0;
    /// A picture of a texture's base level, upright, its texels to be seen, valid until the next call. It may
    /// be that of before, or none, until `levels` has it.
    [[nodiscard]] virtual view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                                          LevelsSource& levels) = 0;
    /// Whether what `showTexture` shows goes on with the next frame.
    [[nodiscard]] virtual bool isUploading() const = 0;
    /// What was not shown since the last call is forgotten.
    virtual void endFrame() = 0;

    // The panels. Dear ImGui's context exists from `startPanels` to `endPanels`.
    virtual void startPanels() = 0;
    virtual void endPanels() = 0;
    virtual void fontsChanged() = 0;
    virtual void beginFrame() = 0; ///< right before the display's size is set
    /// Clears the framebuffer, which has this size, to `ground` and draws what Dear ImGui has collected.
    virtual void drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) = 0;
    /// What `drawPanels` has just drawn: Rgba8, bottom row first.
    [[nodiscard]] virtual Image readPanels(view::Size pixels) = 0;
    /// See ui::Pictures::setBlending.
    [[nodiscard]] virtual ImDrawCallback blendingSwitch() const = 0;
};

} // namespace texplorer::stage
