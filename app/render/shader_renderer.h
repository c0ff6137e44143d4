#pragma once

#include "app/render/scene_renderer.h"
#include "app/view/offered_renderers.h"
#include "texplorer/scene/renderer.h"

#include <filesystem>
#include <functional>

namespace texplorer::render {

/// The source of the shader renderer's shaders.
struct ShaderOptions {
    /// A folder with the files of shaders/, which are read again when they change; empty: the built-in ones.
    /// If they cannot be read or compiled, a sentence in Frame::problems says why, and the last valid ones
    /// stay in use.
    std::filesystem::path folder;
    std::function<void()> wake; ///< called on another thread when a file has changed, to draw again
};

/// Draws a Scene with GLSL 3.30 programs, one per pass, written by shader_source.h.
class ShaderRenderer : public SceneRenderer {
public:
    /// Fails if the driver has no GLSL 3.30.
    [[nodiscard]] static Result<ShaderRenderer> create(const view::Capabilities& capabilities,
                                                       const ShaderOptions& options = {});

private:
    using SceneRenderer::SceneRenderer;
};

/// The renderers that this driver supports.
[[nodiscard]] view::OfferedRenderers offeredRenderers(const view::Capabilities& capabilities);

/// Creates the renderer of this kind. `options` are for the shader renderer. The reference does not use
/// OpenGL: see core/reference/draw.h.
[[nodiscard]] Result<SceneRenderer> createRenderer(RendererKind kind, const view::Capabilities& capabilities,
                                                   const ShaderOptions& options = {});

} // namespace texplorer::render
