#pragma once

#include "core/compare/pixel_metric.h"

namespace texplorer {

/// The absolute difference of a pixel's worst component, in 255ths.
[[nodiscard]] std::unique_ptr<PixelMetric> makeAbsolute(Compared compared);

} // namespace texplorer
