#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer::render {

/// Sets the per-fragment operations that no shader replaces: OpenGL 2.1, sections 4.1.6 and 4.1.8.
void applyDepthAndBlend(const Pass& pass);

/// Sets the widths of lines and points: sections 3.3 and 3.4.
void applyLineAndPoint(const Model& model);

} // namespace texplorer::render
