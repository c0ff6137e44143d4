#pragma once

#include "texplorer/compare/pixel_metric.h"

namespace texplorer {

/// LDR-FLIP of each pixel: Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020, with the
/// paper's constants. Stored components are sRGB. Beyond the edges, the nearest pixel repeats. The paper does
/// not cover alpha: unless `opaque`, both pictures are compared over black and over white, and a pixel has
/// the larger of the two errors.
[[nodiscard]] std::unique_ptr<PixelMetric> makeFlip(double pixelsPerDegree, bool opaque, const Tile& maxTile);

} // namespace texplorer
