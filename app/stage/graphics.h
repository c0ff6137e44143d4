#pragma once

#include "app/view/capabilities.h"
#include "app/view/frame.h"
#include "app/view/offered_renderers.h"
#include "app/view/side.h"
#include "app/view/texture_cost.h"
#include "texplorer/base/result.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/renderer.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/levels_source.h"

#include <imgui.h>

#include <memory>

namespace texplorer::stage {

/// The graphics that a host provides to its stage: draw the scene, keep pictures for panels, and draw the
/// panels. Owned by the host; must outlive the stage.
class Graphics {
public:
    Graphics() = default;
    Graphics(const Graphics&) = delete;
    Graphics& operator=(const Graphics&) = delete;
    virtual ~Graphics() = default;

    /// The driver's capabilities, if there is one.
    [[nodiscard]] virtual const view::Capabilities& capabilities() const = 0;

    /// The renderers that `draw` supports, and the reference, which does not use this class. May change
    /// between two frames.
    [[nodiscard]] virtual const view::OfferedRenderers& renderers() const = 0;

    /// Draws the scene with an offered renderer, never RendererKind::Reference. The error says what it
    /// refused. A texture keeps its previous content until `levels` has the new one. Each side has its own
    /// pictures and textures.
    [[nodiscard]] virtual Result<view::Frame> draw(RendererKind renderer, view::Side side, const Scene& scene,
                                                   const ImageSource& images, double time, view::Size size,
                                                   LevelsSource& levels) = 0;
    /// The last picture of a side by this renderer: Rgba8, bottom row first.
    [[nodiscard]] virtual Result<Image> read(RendererKind renderer, view::Side side) = 0;

    enum class Use {
        Scaled,   ///< to any size: filtered linearly
        Enlarged, ///< with visible pixels
    };
    /// A picture of the image, valid until `endFrame` has been called twice. Use an image always in the same
    /// way.
    [[nodiscard]] virtual view::PictureHandle show(const std::shared_ptr<const Image>& image, Use use) = 0;
    /// A picture of a texture's base level, upright, with visible texels, valid until the next call. It may
    /// be the previous one, or none, until `levels` has it.
    [[nodiscard]] virtual view::PictureHandle showTexture(const Texture& texture, const ImageSource& images,
                                                          LevelsSource& levels) = 0;
    /// Whether `showTexture` continues in the next frame.
    [[nodiscard]] virtual bool isUploading() const = 0;
    /// Measures what textures cost; nullptr: without fixed function it can't.
    [[nodiscard]] virtual std::unique_ptr<view::CostMeter> costMeter(view::CostSubject /*subject*/) {
        return nullptr;
    }
    /// Frees what was not shown since the last call.
    virtual void endFrame() = 0;

    // Starts drawing panels. Dear ImGui's context exists from `startPanels` to `endPanels`.
    virtual void startPanels() = 0;
    virtual void endPanels() = 0;
    virtual void fontsChanged() = 0;
    /// Starts to fetch a font of Chinese letters: a later frame finds it in its folder. False: the host has
    /// no other fonts than those in the folders.
    [[nodiscard]] virtual bool fetchFont() { return false; }
    virtual void beginFrame() = 0; ///< right before the display's size is set
    /// Clears the framebuffer of this size to `ground` and draws the data of Dear ImGui.
    virtual void drawPanels(ImDrawData& panels, view::Size pixels, const ImVec4& ground) = 0;
    /// The result of the last `drawPanels`: Rgba8, bottom row first.
    [[nodiscard]] virtual Image readPanels(view::Size pixels) = 0;
    /// See ui::Pictures::setBlending.
    [[nodiscard]] virtual ImDrawCallback blendingSwitch() const = 0;
};

} // namespace texplorer::stage
