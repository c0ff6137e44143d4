#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer::ui {

// Camera moves by the mouse. Distances on the screen are in pixels, y downwards.

void orbit(View& view, float dx, float dy);

/// Moves the target in the view's plane so that the point under the mouse, at the target's depth, stays
/// there.
void pan(View& view, float dx, float dy, float viewHeight);

/// Positive steps move closer: one notch of a wheel is a tenth.
void zoom(View& view, float steps);

/// Aims at the middle of all visible models, then fits the distance.
void frameModels(Scene& scene, double time, float aspect);

/// Sets the smallest distance at which every visible model is completely in a view of this width / height. A
/// floor is ignored, because it extends to the horizon.
void fitDistance(Scene& scene, double time, float aspect);

} // namespace texplorer::ui
