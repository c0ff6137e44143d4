#pragma once

#include "app/ui/texture_space/texture_space_state.h"

namespace texplorer::ui {

/// The line over the plane: what has room of its tools, and all of them behind "…".
void drawPlaneTools(Session& session, TextureSpaceState& state);

// How much of the plane the panel's shorter side can show.
inline constexpr float smallestPlane = 0.02F;
inline constexpr float largestPlane = 200;

/// The visible part of the plane becomes that with the image and every vertex.
void fitPlane(Plane& plane, const PlaneCoords& coords);

/// The edited vertices' coordinates to the clipboard, a line each.
void copyCoords(Session& session, const PlaneCoords& coords);

/// Lines of the clipboard become the coordinates of as many vertices: the edited ones, or all. Where they
/// don't fit, a sentence says why, and nothing changes.
void pasteCoords(Session& session, const PlaneCoords& coords);

} // namespace texplorer::ui
