#pragma once

#include "app/ui/texture_space/texture_space_state.h"

namespace texplorer::ui {

/// The toolbar above the plane: the tools that fit, and all of them behind "…".
void drawPlaneTools(const Session& session, TextureSpaceState& state);

// The smallest part of the plane along the panel's shorter side.
inline constexpr float minPlane = 0.02F;
inline constexpr float maxPlane = 200;

/// Makes the image and every vertex visible.
void fitPlane(const Session& session, const PlaneCoords& coords);

/// Copies the edited vertices' coordinates to the clipboard, one line each.
void copyCoords(const Session& session, const PlaneCoords& coords);

/// Pastes lines of the clipboard as the coordinates of that many vertices: the edited ones, or all. If they
/// do not fit, a sentence says why, and nothing changes.
void pasteCoords(const Session& session, const PlaneCoords& coords);

} // namespace texplorer::ui
