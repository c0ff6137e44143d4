#pragma once

#include "app/render/capabilities.h"
#include "app/view/frame.h"
#include "core/base/result.h"
#include "core/image/image.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"
#include "core/texture/levels_source.h"
#include "core/texture/texture_levels.h"

#include <memory>

namespace texplorer::render {

class Pipeline;

/// Draws a Scene with OpenGL into a framebuffer object of its own; FixedRenderer and ShaderRenderer make one.
/// It belongs to the context that is current, on its thread, and is destroyed before the context is. Leaves
/// the caller's GL state as it found it.
class SceneRenderer {
public:
    SceneRenderer(const view::Capabilities& capabilities, std::unique_ptr<Pipeline> pipeline);
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;
    SceneRenderer(SceneRenderer&&) noexcept;
    SceneRenderer& operator=(SceneRenderer&&) noexcept;
    ~SceneRenderer();

    /// Draws the scene at `time` seconds, with what its key frames say then. Refused: a size below 1 or above
    /// the driver's limit. A GL error does not end the drawing: it is reported in Frame::problems. Without
    /// `levels` the textures are made and uploaded before the drawing; with it, a texture is what it was
    /// before until they are.
    [[nodiscard]] Result<view::Frame> draw(const Scene& scene, const ImageSource& images, double time,
                                           view::Size size, LevelsSource* levels = nullptr);

    /// Uses the textures of a renderer in the same context that draws the same scenes, instead of its own.
    void shareTextures(const SceneRenderer& other);

    /// The levels of one of the textures that the last scene was drawn with, as the driver holds them: what
    /// it compressed is read back as blocks. Refused where the texture was not drawn with this target.
    [[nodiscard]] Result<std::vector<TextureLevel>> readTexture(std::size_t index,
                                                                Target target = Target::Texture2D);

    /// Reads the last picture back: Rgba8, bottom row first.
    [[nodiscard]] Result<Image> read();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace texplorer::render
