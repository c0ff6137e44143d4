#pragma once

#include "app/render/shader_renderer.h"
#include "app/stage/graphics.h"
#include "app/view/pretence.h"

#include <memory>

namespace texplorer::opengl {

/// What the context that is current can do for a window: OpenGlGraphics, or where it is a core profile
/// CoreGraphics, which draws with the reference alone and has nothing to pretend. The error says what the
/// driver lacks.
[[nodiscard]] Result<std::unique_ptr<stage::Graphics>>
createWindowGraphics(render::ShaderOptions shaders = {}, const view::Pretence& pretence = {});

} // namespace texplorer::opengl
