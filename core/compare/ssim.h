#pragma once

#include "core/compare/pixel_metric.h"

namespace texplorer {

/// 1 - SSIM of each pixel: Wang, Bovik, Sheikh, Simoncelli 2004, equation 13, with the paper's window, a
/// Gaussian of 11 x 11 pixels and a standard deviation of 1.5 that sums up to 1, K1 = 0.01, K2 = 0.03, L =
/// 255. What the paper leaves open: each of red, green and blue is measured as it is stored, and alpha too
/// unless `opaque`, and a pixel has the mean of them; every pixel has a window, in which the nearest pixel
/// repeats beyond the pictures' edges. That is ImageMagick 7's SSIM (-metric SSIM before 7.1.2; 7.1.2 prints
/// half of 1 - SSIM), and within 5 pixels of no edge that of scikit-image.
[[nodiscard]] std::unique_ptr<PixelMetric> makeSsim(bool opaque, const Tile& largest);

} // namespace texplorer
