#pragma once

#include "texplorer/scene/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace texplorer::reference {

/// Returns the largest |s / q|, |t / q| and |r / q| of a unit's coordinates at the vertices that a pass
/// draws. Infinite values and NaN are ignored.
[[nodiscard]] glm::vec3 coordinateReach(const Scene& scene, std::size_t pass, std::size_t unit, double time);

} // namespace texplorer::reference
