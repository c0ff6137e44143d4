#pragma once

// A triangle, line or point made ready for rasterising: OpenGL 2.1, sections 3.3, 3.4 and 3.5.1.

#include "core/reference/shading/vertex.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace texplorer::reference {

struct PassState;

/// A value that changes linearly over the window: `origin` at the triangle's own origin.
template<class T>
struct Plane {
    T origin{0};
    T dx{0}; ///< a pixel to the right
    T dy{0}; ///< a pixel up

    [[nodiscard]] T at(glm::vec2 offset) const { return (origin + dy * offset.y) + dx * offset.x; }
};

/// Where a pixel's centre lies in relation to an edge, in 1/256 of a pixel squared: not negative inside.
struct EdgeFunction {
    std::int64_t origin = 0; ///< at the centre of pixel (0, 0)
    std::int64_t dx = 0;
    std::int64_t dy = 0;
    double inverse = 0; ///< 1 / |dx|; infinite where dx is 0
};

/// Window positions are snapped to 1/256 of a pixel for the edges, so that triangles which share one leave no
/// gap and hit no pixel twice. What is interpolated is divided by w first ("over w"); dividing it by the
/// interpolated 1/w makes it perspective-correct (equation 3.6). Without perspective correction w counts
/// as 1.
///
/// Lines and points are no triangles, and are drawn alike: what they cover lies between two edges at most and
/// within the limits below.
struct Triangle {
    const PassState* pass = nullptr;
    std::array<EdgeFunction, 3> edges{};
    bool seenFromBehind = false; ///< clockwise in the window
    int minX = 0;                ///< the pixels whose centres may lie inside
    int maxX = -1;
    int minY = 0;
    int maxY = -1;
    glm::vec2 origin{0}; ///< of the planes, relative to the centre of pixel (0, 0)
    Plane<float> depth{};
    Plane<float> invW{};
    Plane<glm::vec4> primary{};
    std::optional<glm::vec4> evenPrimary{}; ///< the primary colour, where the three corners share it
    Plane<glm::vec4> secondary{};
    Plane<float> fogDistance{};
    std::array<Plane<glm::vec4>, maxUnits> texCoords{};
};

struct Viewport {
    int width = 0;
    int height = 0;
    int cornerBits = 0; ///< see DrawRequest
};

/// The number of pixels that a line width or a point size is rounded to.
[[nodiscard]] int roundedSize(float size);

/// A line of section 3.4: its pixels by the diamond-exit rule, and as many of them across as it is wide;
/// `width` is rounded. What is interpolated changes along the line alone (equation 3.5). nullopt where it has
/// none.
[[nodiscard]] std::optional<Triangle> setUpLine(const ShadedVertex& from, const ShadedVertex& to, float width,
                                                const PassState& pass, Viewport viewport, bool perspective);

/// A point of section 3.3: a square of `size` pixels, which is rounded, with the values of its vertex.
[[nodiscard]] std::optional<Triangle> setUpPoint(const ShadedVertex& vertex, float size,
                                                 const PassState& pass, Viewport viewport, bool perspective);

/// nullopt where no pixel's centre can lie inside. `perspective` off is the cheap interpolation that
/// GL_PERSPECTIVE_CORRECTION_HINT once allowed.
[[nodiscard]] std::optional<Triangle> setUp(const ShadedVertex& a, const ShadedVertex& b,
                                            const ShadedVertex& c, const PassState& pass, Viewport viewport,
                                            bool perspective);

} // namespace texplorer::reference
