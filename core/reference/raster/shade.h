#pragma once

// The colour of a fragment: OpenGL 2.1, sections 3.8 (texturing), 3.9 (colour sum), 3.10 (fog) and 4.1
// (per-fragment operations).

#include "texplorer/reference/raster/canvas.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/shading/pass_state.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace texplorer::reference {

/// Where a unit samples: coordinates divided by q, and their change per pixel.
struct TexturePlace {
    glm::vec4 homogeneous{0}; ///< s, t, r, q, interpolated
    glm::vec3 coords{0};
    Derivatives derivatives;
};

/// `offset` is the pixel's centre relative to the triangle's origin. For q = 0 the coordinates are infinite
/// or NaN, which the sampler handles.
[[nodiscard]] TexturePlace texturePlace(const Triangle& triangle, std::size_t unit, glm::vec2 offset);

/// Section 2.14.9: clamped to [0, 1].
[[nodiscard]] glm::vec4 primaryColor(const Triangle& triangle, glm::vec2 offset);

/// The colour after texturing and colour sum.
[[nodiscard]] glm::vec4 summedColor(const Triangle& triangle, glm::vec2 offset);

/// Section 3.10: the distance of a fragment from the eye's plane, which the specification allows instead of
/// the distance from the eye. Only for passes with fog.
[[nodiscard]] float fogDistance(const Triangle& triangle, glm::vec2 offset);

/// The colour after texturing, colour sum and fog.
[[nodiscard]] glm::vec4 fragmentColor(const Triangle& triangle, glm::vec2 offset);

/// Window depth in 24 bits. NaN counts as 0.
[[nodiscard]] std::uint32_t fragmentDepth(const Triangle& triangle, glm::vec2 offset);

} // namespace texplorer::reference
