#pragma once

// Fragments of a whole picture: the same bytes as shade.h and raster.cpp's literal fragment, which are the
// text to read, for several pixels of a row at a time.

#include "core/reference/canvas.h"
#include "core/reference/fast_sampler.h"
#include "core/reference/triangle.h"

#include <cstdint>

namespace texplorer::reference {

/// How many pixels are drawn together at most.
inline constexpr int rowCapacity = SampleRow::capacity;

/// Draws `count` pixels (1 to rowCapacity) of the triangle, from (x, y) to the right: depth test, texturing,
/// colour sum, alpha test, blending.
void drawRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas);

/// The same in two steps, for passes that neither blend nor test alpha: first the depth test alone, which
/// puts `number` where it succeeds. When all triangles have been marked, what a pixel was given last owns it,
/// and no hidden pixel is ever shaded.
void markRow(const Triangle& triangle, std::uint32_t number, int x, int y, int count, Canvas& canvas,
             std::uint32_t* owners);
void shadeRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas);

} // namespace texplorer::reference
