#pragma once

#include "core/image/image.h"
#include "core/reference/raster/triangle.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// A picture being drawn: eight bits a component and 24 bits of depth, as the GL framebuffer. The rasteriser
/// clears it, with what it draws first: a tile that is in a processor's cache is drawn at once.
struct Canvas {
    Image color;                      ///< Rgba8, bottom row first
    std::vector<std::uint32_t> depth; ///< one a pixel, if more is to be drawn over it; else empty
    std::uint32_t background = 0;     ///< a pixel's four bytes
    bool cleared = false;

    Canvas(Viewport viewport, glm::vec4 clearColor);

    [[nodiscard]] Viewport viewport() const { return {color.width, color.height}; }
    [[nodiscard]] std::size_t pixelAt(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(color.width) +
               static_cast<std::size_t>(x);
    }
};

inline constexpr std::uint32_t farthestDepth = (1U << 24) - 1;

} // namespace texplorer::reference
