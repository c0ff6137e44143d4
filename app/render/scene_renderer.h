#pragma once

#include "app/render/capabilities.h"
#include "app/view/frame.h"
#include "texplorer/base/result.h"
#include "texplorer/image/image.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"
#include "texplorer/texture/levels_source.h"
#include "texplorer/texture/texture_levels.h"

#include <memory>

namespace texplorer::render {

class Pipeline;

/// Draws a Scene with OpenGL into its own framebuffer object; created by FixedRenderer and ShaderRenderer. It
/// belongs to the current context and its thread and must be destroyed before the context. Restores the
/// caller's GL state.
class SceneRenderer {
public:
    SceneRenderer(const view::Capabilities& capabilities, std::unique_ptr<Pipeline> pipeline);
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    /// Draws the scene at `time` seconds, with its key frames applied. Fails for a size below 1 or above the
    /// driver's limit. A GL error does not stop drawing: it is reported in Frame::problems. Without `levels`
    /// textures are made and uploaded before drawing; with it, a texture keeps its previous content until
    /// they are.
    [[nodiscard]] Result<view::Frame> draw(const Scene& scene, const ImageSource& images, double time,
                                           view::Size size, LevelsSource* levels = nullptr);

    /// Uses the textures of another renderer in the same context that draws the same scenes.
    void shareTextures(const SceneRenderer& other);

    /// The levels of a texture of the last scene, as the driver holds them: compressed levels are read back
    /// as blocks. Fails if the texture was not drawn with this target.
    [[nodiscard]] Result<std::vector<TextureLevel>> readTexture(std::size_t index,
                                                                Target target = Target::Texture2D);

    /// Reads the last picture: Rgba8, bottom row first.
    [[nodiscard]] Result<Image> read();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::render
