#pragma once

#include "core/scene/scene.h"

namespace texplorer {

/// Makes the light project what a unit shows: s, t, r and q are generated in eye coordinates, and the texture
/// matrix ends with the projector. Its other steps stay. Refused (false) where the matrix has no room.
bool projectFromLight(Unit& unit);

/// Makes a unit of a pass multiply by the light's shadows: it shows a new texture of what the light sees,
/// which r is compared with, and the light projects it. What its texture matrix was goes. Refused (false)
/// where the scene has no room for a texture.
bool castShadows(Scene& scene, std::size_t pass, std::size_t unit);

} // namespace texplorer
