#pragma once

// Which face of a cube map a direction hits, and where: OpenGL 2.1, section 3.8.6.

#include "core/reference/sampling/lod.h"

namespace texplorer::reference {

/// The face, the coordinates on it, and how these change from pixel to pixel.
struct CubePlace {
    int face = 0;        ///< +x, -x, +y, -y, +z, -z
    glm::vec3 coords{0}; ///< s and t from 0 to 1; r is 0
    Derivatives derivatives{};
};

/// (s, t, r) is a direction of any length. Where two of its components are equally large the specification
/// leaves the choice open: x goes before y, and y before z. A direction that is 0, infinite or no number
/// hits the middle of +x.
[[nodiscard]] CubePlace cubePlace(glm::vec3 direction, const Derivatives& derivatives);

} // namespace texplorer::reference
