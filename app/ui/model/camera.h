#pragma once

#include "core/scene/scene.h"

namespace texplorer::ui {

// Camera moves by the mouse, on the value. Distances on the screen are in pixels, y downwards.

void orbit(View& view, float dx, float dy);

/// Moves the target in the view's plane so that what is under the mouse at the target's depth stays under it.
void pan(View& view, float dx, float dy, float viewHeight);

/// Positive steps go nearer: one notch of a wheel is a tenth.
void zoom(View& view, float steps);

/// Aims at the middle of all visible models, then fits the distance.
void frameModels(Scene& scene, double time, float aspect);

/// The nearest distance from which every visible model is whole, in a view of this width / height. A floor
/// runs to the horizon: it doesn't count.
void fitDistance(Scene& scene, double time, float aspect);

} // namespace texplorer::ui
