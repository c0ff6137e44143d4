#pragma once

#include "core/scene/scene.h"

#include <span>

namespace texplorer {

/// Makes the first model of the shape visible, and part of every pass where none draws it; adds one where the
/// scene has none, in the place of the last one where it is full.
void showShape(Scene& scene, Shape shape);

/// The same of each shape, and every other model becomes invisible.
void showOnlyShapes(Scene& scene, std::span<const Shape> shapes);

/// Looks along the floor, from low above its near end.
void lookAlongFloor(View& view);

} // namespace texplorer
