#pragma once

#include "core/scene/scene.h"

namespace texplorer::render {

/// The per-fragment operations that no shader takes over: OpenGL 2.1, sections 4.1.6 and 4.1.8.
void applyDepthAndBlend(const Pass& pass);

} // namespace texplorer::render
