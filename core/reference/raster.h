#pragma once

#include "core/image/image.h"
#include "core/reference/triangle.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace texplorer::reference {

/// A picture being drawn: eight bits a component and 24 bits of depth, as the GL framebuffer.
struct Canvas {
    Image color;                      ///< Rgba8, bottom row first
    std::vector<std::uint32_t> depth; ///< one a pixel

    /// Throws std::bad_alloc.
    Canvas(Viewport viewport, glm::vec4 background);
    [[nodiscard]] Viewport viewport() const { return {color.width, color.height}; }
};

/// Draws triangles in their order. Tiles of the picture are drawn by up to `threads` threads; the result is
/// the same with any number. Stops early when it is asked to. Throws std::bad_alloc.
void rasterize(std::span<const Triangle> triangles, Canvas& canvas, unsigned threads, std::stop_token stop);

/// The pixels of one row that a triangle covers, within [first, last]; empty where the first is greater.
struct Span {
    int first;
    int last;
};
[[nodiscard]] Span coveredPixels(const Triangle& triangle, int y, Span within);

} // namespace texplorer::reference
