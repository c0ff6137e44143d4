#pragma once

#include "core/image/image.h"
#include "core/image/mip_options.h"

namespace texplorer {

/// The power of two that gluBuild2DMipmaps scales an extent to: the nearest, where the middle between two is
/// 1.5 times the smaller one, and that goes up (5 -> 4, 6 -> 8, 640 -> 512, 800 -> 1024). At least 1.
[[nodiscard]] int nearestPowerOfTwo(int extent);

/// Scales to any size, smaller or larger: every texel is the average of what it covers of `from`, exactly, as
/// gluScaleImage does it. Rounds to nearest. The new extents must be at least 1.
[[nodiscard]] Image scaleByCoverage(const Image& from, int width, int height, int depth = 1);

/// The image with every extent at its nearest power of two; the image itself where it is there already.
[[nodiscard]] Image toPowerOfTwo(Image image);

/// A picture scaled by a filter of stb_image_resize, with clamped edges. Every slice of a volume by itself.
[[nodiscard]] Image scaleFiltered(const Image& from, int width, int height, MipFilter filter,
                                  bool linearLight);

} // namespace texplorer
