#pragma once

// What the vertex stage gives: OpenGL 2.1, sections 2.11 (transformation, texture matrix) and 2.12
// (clipping).

#include "core/reference/shading/lighting.h"
#include "core/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace texplorer::reference {

struct ShadedVertex {
    glm::vec4 clip{0};    ///< clip coordinates
    glm::vec4 primary{1}; ///< colours: see lighting.h
    glm::vec3 secondary{0};
    std::array<glm::vec4, maxUnits> texCoords{}; ///< s, t, r, q after the texture matrix
    VertexColors back{};                         ///< of faces seen from behind, where both sides are lit
    float fogDistance = 0;                       ///< from the eye's plane: section 3.10
};

/// A convex polygon or a line: what clipping leaves of a triangle or line.
using Polygon = std::vector<ShadedVertex>;

/// How far outside of the view, in halves of its extent, a polygon may reach in x and y. GL cuts it at the
/// view itself; what is beyond is never seen, and one cut less is one rounding less.
inline constexpr float guardBand = 8;

/// Cuts a triangle at the near and far planes and at the guard band; empty where nothing is left, or where a
/// vertex is NaN or infinite. What is behind the eye (w <= 0) is beyond the near plane. Without `perspective`
/// colours and coordinates stay linear in the window, as OpenGL 3.0 says of `noperspective` (section 2.17).
[[nodiscard]] Polygon clip(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c,
                           bool perspective = true);

/// Whether clip() leaves the triangle as it is, as it does with most.
[[nodiscard]] bool isInside(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c);

/// The same for a line: two vertices, or none where nothing is left.
[[nodiscard]] Polygon clipLine(const ShadedVertex& a, const ShadedVertex& b, bool perspective = true);

/// Whether a point is drawn: its vertex, not what it covers, is in the view volume.
[[nodiscard]] bool isInView(const ShadedVertex& vertex);

} // namespace texplorer::reference
