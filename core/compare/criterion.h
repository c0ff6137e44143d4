#pragma once

// When two pictures count as alike.

#include "texplorer/base/result.h"
#include "texplorer/compare/difference.h"
#include "texplorer/compare/metric.h"

#include <optional>
#include <string>
#include <string_view>

namespace texplorer {

/// Two pictures are alike if at most `share` of the pixels have a value above `tolerance`.
struct Criterion {
    Metric metric = Metric::Absolute;
    /// The largest value that is tolerated. Absolute: difference of the worst component, 0 to 255. Ssim: 1 -
    /// SSIM at the pixel, 0 to 2. Flip: the FLIP error at the pixel, 0 to 1.
    double tolerance = factsOf(Metric::Absolute).tolerance;
    double share = 0; ///< of the compared pixels, 0 to 1
    Compared compared = Compared::Rgba;
    /// Flip: pixels per degree of the viewer's field of view; 67 is the paper's 0.7 m from a 4K screen.
    double pixelsPerDegree = 67;

    bool operator==(const Criterion&) const = default;
};

inline constexpr double minPixelsPerDegree = 1;
inline constexpr double maxPixelsPerDegree = 512;

/// The metric with its default tolerance.
[[nodiscard]] Criterion criterionOf(Metric metric);

/// OutOfRange names the wrong member ("tolerance", "share", "pixelsPerDegree") and its range.
[[nodiscard]] Result<void> checkCriterion(const Criterion& criterion);

/// Parses "0.05" or "5%" as a share of 0 to 1; or a tolerance in the metric's range. The text must be a
/// number and nothing else. Errors: OutOfRange; `where` is empty.
[[nodiscard]] Result<double> parseShare(std::string_view text);
[[nodiscard]] Result<double> parseTolerance(std::string_view text, Metric metric);

} // namespace texplorer
