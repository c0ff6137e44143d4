#pragma once

// Vertices in the window: OpenGL 2.1, section 2.11.1.

#include "texplorer/reference/raster/triangle.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace texplorer::reference {

inline constexpr int subPixels = 256; // as in llvmpipe; the specification leaves the number open

struct Corner {
    const ShadedVertex* vertex;
    glm::dvec2 window; ///< relative to the centre of pixel (0, 0), y upwards
    double depth;      ///< 0 to 1
    double invW;
    std::int64_t x; ///< window, snapped
    std::int64_t y;
};

[[nodiscard]] Corner cornerOf(const ShadedVertex& vertex, Viewport viewport, bool perspective);

/// The range of pixels whose centres are in a range of snapped positions.
[[nodiscard]] constexpr int pixelAtOrAfter(std::int64_t snapped) {
    return static_cast<int>((snapped + subPixels - 1) >> 8);
}
[[nodiscard]] constexpr int pixelAtOrBefore(std::int64_t snapped) {
    return static_cast<int>(snapped >> 8);
}

} // namespace texplorer::reference
