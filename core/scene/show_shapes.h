#pragma once

#include "texplorer/scene/scene.h"

#include <span>

namespace texplorer {

/// Makes the first model of the shape visible, and adds it to every pass if none draws it; if the scene has
/// no such model, adds one, or replaces the last one if the scene is full.
void showShape(Scene& scene, Shape shape);

/// The same for several shapes; all other models become invisible.
void showOnlyShapes(Scene& scene, std::span<const Shape> shapes);

/// Sets a view along the floor, from low above its near end.
void lookAlongFloor(View& view);

} // namespace texplorer
