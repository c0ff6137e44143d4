#pragma once

// Fragments of a whole picture: the same bytes as shade.h and raster.cpp's literal fragment, which are the
// text to read, for several pixels of a row at a time.

#include "core/reference/canvas.h"
#include "core/reference/fast_sampler.h"
#include "core/reference/triangle.h"

namespace texplorer::reference {

/// How many pixels are drawn together at most.
inline constexpr int rowCapacity = SampleRow::capacity;

/// Draws `count` pixels (1 to rowCapacity) of the triangle, from (x, y) to the right: depth test, texturing,
/// colour sum, alpha test, blending.
void drawRow(const Triangle& triangle, int x, int y, int count, Canvas& canvas);

} // namespace texplorer::reference
