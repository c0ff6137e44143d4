#pragma once

#include "core/scene/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace texplorer::reference {

/// How far from 0 the coordinates of a unit get at the vertices that a pass draws: the largest |s / q|, |t /
/// q| and |r / q|. What is infinite or no number doesn't count.
[[nodiscard]] glm::vec3 coordinateReach(const Scene& scene, const Pass& pass, std::size_t unit, double time);

} // namespace texplorer::reference
