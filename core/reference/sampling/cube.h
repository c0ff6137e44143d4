#pragma once

// Which face of a cube map a direction hits, and where: OpenGL 2.1, section 3.8.6. Which texels lie beyond
// the edges of a face: ARB_seamless_cube_map.

#include "core/reference/sampling/lod.h"

#include <glm/vec2.hpp>

#include <optional>

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

/// A texel of a face; counted on beyond its edges where a function says so.
struct FaceTexel {
    int face = 0;
    glm::ivec2 index{0};

    bool operator==(const FaceTexel&) const = default;
};

/// The texel where the plane of a face, with `size` texels along each edge, is folded around the cube: one
/// counted on beyond an edge, by `size` at most, lies on the face next to it. nullopt beyond two edges, where
/// three faces meet and there is none.
[[nodiscard]] std::optional<FaceTexel> foldedTexel(const FaceTexel& texel, int size);

/// The other way round: where a texel lies in the plane of the face `onto`, counted on beyond its edges.
/// nullopt on the opposite face, which shares no edge with it.
[[nodiscard]] std::optional<glm::ivec2> unfoldedTexel(const FaceTexel& texel, int onto, int size);

} // namespace texplorer::reference
