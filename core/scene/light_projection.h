#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer {

/// Lets the light project a unit's texture: s, t, r and q are generated in eye coordinates, and the texture
/// matrix ends with the projector. Its other steps stay. Returns false, without changes, if the matrix has no
/// room.
bool projectFromLight(Unit& unit);

/// Makes a unit of a pass multiply by the light's shadows: it uses a new depth texture of the light's view,
/// compared with r and projected by the light. Its previous texture matrix is removed. Returns false, without
/// changes, if the scene has no room for a texture.
bool castShadows(Scene& scene, std::size_t pass, std::size_t unit);

} // namespace texplorer
