#pragma once

#include "texplorer/compare/pixel_metric.h"

namespace texplorer {

/// The absolute difference of a pixel's worst component, in units of 1/255.
[[nodiscard]] std::unique_ptr<PixelMetric> makeAbsolute(Compared compared);

} // namespace texplorer
