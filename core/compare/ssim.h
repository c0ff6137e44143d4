#pragma once

#include "texplorer/compare/pixel_metric.h"

namespace texplorer {

/// 1 - SSIM of each pixel: Wang, Bovik, Sheikh, Simoncelli 2004, equation 13, with the paper's window, a
/// Gaussian of 11 x 11 pixels with a standard deviation of 1.5 and the sum 1, K1 = 0.01, K2 = 0.03, L = 255.
/// Choices that the paper leaves open: red, green and blue are measured as stored, alpha too unless `opaque`,
/// and a pixel has their mean; every pixel has a window, in which the nearest pixel repeats beyond the edges.
/// This equals ImageMagick 7's SSIM (-metric SSIM before 7.1.2; 7.1.2 prints half of 1 - SSIM), and
/// scikit-image's except within 5 pixels of an edge.
[[nodiscard]] std::unique_ptr<PixelMetric> makeSsim(bool opaque, const Tile& maxTile);

} // namespace texplorer
