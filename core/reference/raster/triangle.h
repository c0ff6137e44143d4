#pragma once

// Triangles, lines and points set up for rasterising: OpenGL 2.1, sections 3.3, 3.4 and 3.5.1.

#include "texplorer/reference/shading/vertex.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace texplorer::reference {

struct PassState;

/// A value that is linear over the window; `origin` is the value at the triangle's origin.
template<class T>
struct Plane {
    T origin{0};
    T dx{0}; ///< per pixel to the right
    T dy{0}; ///< per pixel up

    [[nodiscard]] T at(glm::vec2 offset) const { return (origin + dy * offset.y) + dx * offset.x; }
};

/// The position of a pixel's centre relative to an edge, in 1/256 of a pixel squared: not negative inside.
struct EdgeFunction {
    std::int64_t origin = 0; ///< at the centre of pixel (0, 0)
    std::int64_t dx = 0;
    std::int64_t dy = 0;
    double inverse = 0; ///< 1 / |dx|; infinite for dx = 0
};

/// For edges, window positions are snapped to 1/256 of a pixel, so that triangles with a common edge leave no
/// gap and draw no pixel twice. Values are divided by w before interpolation ("over w") and by the
/// interpolated 1/w afterwards, which makes them perspective-correct (equation 3.6). Without perspective
/// correction, w is 1.
///
/// Lines and points are drawn by the same code: they cover what is between at most two edges and within the
/// limits below.
struct Triangle {
    const PassState* pass = nullptr;
    std::array<EdgeFunction, 3> edges{};
    bool seenFromBehind = false; ///< clockwise in the window
    int minX = 0;                ///< the pixels whose centres can be inside
    int maxX = -1;
    int minY = 0;
    int maxY = -1;
    glm::vec2 origin{0}; ///< of the planes, relative to the centre of pixel (0, 0)
    Plane<float> depth{};
    Plane<float> invW{};
    Plane<glm::vec4> primary{};
    std::optional<glm::vec4> evenPrimary{}; ///< the primary colour, if the three corners have the same
    Plane<glm::vec4> secondary{};
    Plane<float> fogDistance{};
    std::array<Plane<glm::vec4>, maxUnits> texCoords{};
};

struct Viewport {
    int width = 0;
    int height = 0;
    int cornerBits = 0; ///< see DrawRequest
};

/// A line width or point size, rounded to pixels.
[[nodiscard]] int roundedSize(float size);

/// Sets up a line (section 3.4): its pixels by the diamond-exit rule, repeated to its rounded `width`. Values
/// change along the line only (equation 3.5). nullopt if it covers no pixels.
[[nodiscard]] std::optional<Triangle> setUpLine(const ShadedVertex& from, const ShadedVertex& to, float width,
                                                const PassState& pass, Viewport viewport, bool perspective);

/// Sets up a point (section 3.3): a square of `size` pixels, rounded, with the values of its vertex.
[[nodiscard]] std::optional<Triangle> setUpPoint(const ShadedVertex& vertex, float size,
                                                 const PassState& pass, Viewport viewport, bool perspective);

/// Sets up a triangle. nullopt if no pixel's centre can be inside. Without `perspective`, interpolation is
/// linear in the window, which GL_PERSPECTIVE_CORRECTION_HINT once allowed.
[[nodiscard]] std::optional<Triangle> setUp(const ShadedVertex& a, const ShadedVertex& b,
                                            const ShadedVertex& c, const PassState& pass, Viewport viewport,
                                            bool perspective);

} // namespace texplorer::reference
