#pragma once

#include "app/render/scene_renderer.h"

namespace texplorer::render {

/// Draws a Scene with OpenGL's fixed-function pipeline.
class FixedRenderer : public SceneRenderer {
public:
    [[nodiscard]] static Result<FixedRenderer> create(const view::Capabilities& capabilities);

private:
    using SceneRenderer::SceneRenderer;
};

} // namespace texplorer::render
