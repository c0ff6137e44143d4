#pragma once

// The face of a cube map that a direction hits, and where: OpenGL 2.1, section 3.8.6. Texels beyond the edges
// of a face: ARB_seamless_cube_map.

#include "texplorer/reference/sampling/lod.h"

#include <glm/vec2.hpp>

#include <optional>

namespace texplorer::reference {

/// The face, the coordinates on it, and their change per pixel.
struct CubePlace {
    int face = 0;        ///< +x, -x, +y, -y, +z, -z
    glm::vec3 coords{0}; ///< s and t from 0 to 1; r is 0
    Derivatives derivatives{};
};

/// (s, t, r) is a direction of any length. If two of its components are equally large, the specification
/// leaves the choice open: x is chosen before y, and y before z. A direction that is 0, infinite or NaN hits
/// the centre of +x.
[[nodiscard]] CubePlace cubePlace(glm::vec3 direction, const Derivatives& derivatives);

/// A texel of a face; beyond its edges where a function says so.
struct FaceTexel {
    int face = 0;
    glm::ivec2 index{0};

    bool operator==(const FaceTexel&) const = default;
};

/// Returns the texel of an index beyond an edge, by at most `size`, the texels along an edge: the texel of
/// the adjacent face at that position, with the plane folded around the cube. nullopt beyond two edges, where
/// three faces meet.
[[nodiscard]] std::optional<FaceTexel> foldedTexel(const FaceTexel& texel, int size);

/// The inverse: the position of a texel in the plane of the face `onto`, beyond its edges. nullopt on the
/// opposite face, which shares no edge with it.
[[nodiscard]] std::optional<glm::ivec2> unfoldedTexel(const FaceTexel& texel, int onto, int size);

} // namespace texplorer::reference
