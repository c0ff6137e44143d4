#pragma once

#include "texplorer/image/image.h"
#include "texplorer/image/mip_options.h"

namespace texplorer {

/// The power of two that gluBuild2DMipmaps scales an extent to: the nearest, where the middle between two is
/// 1.5 times the smaller one and rounds up (5 -> 4, 6 -> 8, 640 -> 512, 800 -> 1024). At least 1.
[[nodiscard]] int nearestPowerOfTwo(int extent);

/// Scales to any size: every texel is the exact average of the area that it covers in `from`, as in
/// gluScaleImage. Rounds to nearest. The new extents must be at least 1.
[[nodiscard]] Image scaleByCoverage(const Image& from, int width, int height, int depth = 1);

/// Scales every extent to its nearest power of two; returns the image unchanged if they are powers of two.
[[nodiscard]] Image toPowerOfTwo(Image image);

/// Scales a picture by a filter of stb_image_resize, with clamped edges. Volumes are scaled slice by slice.
[[nodiscard]] Image scaleFiltered(const Image& from, int width, int height, MipFilter filter,
                                  bool linearLight);

} // namespace texplorer
