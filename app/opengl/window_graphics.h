#pragma once

#include "app/render/shader_renderer.h"
#include "app/stage/graphics.h"
#include "app/view/pretence.h"

#include <memory>

namespace texplorer::opengl {

/// The graphics for the current context of a window: OpenGlGraphics, or CoreGraphics for a core profile,
/// which draws only with the reference and ignores `pretence`. The error says what the driver lacks.
[[nodiscard]] Result<std::unique_ptr<stage::Graphics>>
createWindowGraphics(render::ShaderOptions shaders = {}, const view::Pretence& pretence = {});

/// Waits until the driver has drawn everything in the current context.
void finishDrawing();

} // namespace texplorer::opengl
