#pragma once

#include "core/reference/canvas.h"
#include "core/reference/triangle.h"

#include <span>
#include <stop_token>

namespace texplorer::reference {

/// Draws triangles in their order. Tiles of the picture are drawn by up to `threads` threads; the result is
/// the same with any number. Stops early when it is asked to. `literal`: pixel by pixel, as shade.h has it;
/// the bytes are the same, only later. Throws std::bad_alloc.
void rasterize(std::span<const Triangle> triangles, Canvas& canvas, unsigned threads, std::stop_token stop,
               bool literal = false);

/// The pixels of one row that a triangle covers, within [first, last]; empty where the first is greater.
struct Span {
    int first;
    int last;
};
[[nodiscard]] Span coveredPixels(const Triangle& triangle, int y, Span within);

} // namespace texplorer::reference
