#pragma once

// The output of the vertex stage: OpenGL 2.1, sections 2.11 (transformation, texture matrix) and 2.12
// (clipping).

#include "texplorer/reference/shading/lighting.h"
#include "texplorer/scene/scene.h"

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
    VertexColors back{};                         ///< of back faces, with two-sided lighting
    float fogDistance = 0;                       ///< from the eye's plane: section 3.10
};

/// A convex polygon or a line: a clipped triangle or line.
using Polygon = std::vector<ShadedVertex>;

/// The clip limits in x and y, in half extents of the view. GL clips at the view itself; what is outside is
/// never visible, and one cut less means one rounding less.
inline constexpr float guardBand = 8;

/// Clips a triangle at the near and far planes and at the guard band; empty if nothing is left, or if a
/// vertex is NaN or infinite. Points behind the eye (w <= 0) are beyond the near plane. Without
/// `perspective`, colours and coordinates stay linear in the window, as OpenGL 3.0 defines for
/// `noperspective` (section 2.17).
[[nodiscard]] Polygon clip(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c,
                           bool perspective = true);

/// Whether clip() does not change the triangle, the usual case.
[[nodiscard]] bool isInside(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c);

/// The same for a line: two vertices, or none if nothing is left.
[[nodiscard]] Polygon clipLine(const ShadedVertex& a, const ShadedVertex& b, bool perspective = true);

/// Whether a point is drawn: its vertex, not the pixels that it covers, is in the view volume.
[[nodiscard]] bool isInView(const ShadedVertex& vertex);

} // namespace texplorer::reference
