#pragma once

#include "texplorer/image/image.h"
#include "texplorer/reference/raster/triangle.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// The framebuffer of a picture: eight bits per component and 24 bits of depth, as in OpenGL. The rasteriser
/// clears each tile right before it draws there, while it is in the processor's cache.
struct Canvas {
    Image color;                      ///< Rgba8, bottom row first
    std::vector<std::uint32_t> depth; ///< one per pixel, if more will be drawn over it; else empty
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
