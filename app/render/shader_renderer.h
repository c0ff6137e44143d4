#pragma once

#include "app/render/scene_renderer.h"
#include "app/view/offered_renderers.h"
#include "core/scene/renderer.h"

#include <filesystem>
#include <functional>

namespace texplorer::render {

/// Where the shader renderer has its shaders from.
struct ShaderOptions {
    /// A folder with the files of shaders/, which are read again when they change; empty: those that the
    /// program was built with. Where they can't be read or compiled, a sentence in Frame::problems says why,
    /// and the last ones that could be stay.
    std::filesystem::path folder;
    std::function<void()> wake; ///< called on another thread when a file has changed: draw again
};

/// Draws a Scene with programs in GLSL 3.30, one for each pass, as shader_source.h writes them.
class ShaderRenderer : public SceneRenderer {
public:
    /// Refused by a driver without GLSL 3.30.
    [[nodiscard]] static Result<ShaderRenderer> create(const view::Capabilities& capabilities,
                                                       const ShaderOptions& options = {});

private:
    using SceneRenderer::SceneRenderer;
};

/// Which renderers this driver has.
[[nodiscard]] view::OfferedRenderers offeredRenderers(const view::Capabilities& capabilities);

/// The renderer of this kind. The options are for that with shaders. The reference is none of OpenGL's: see
/// core/reference/draw.h.
[[nodiscard]] Result<SceneRenderer> createRenderer(RendererKind kind, const view::Capabilities& capabilities,
                                                   const ShaderOptions& options = {});

} // namespace texplorer::render
