#pragma once

// What two pictures are held to.

#include "core/base/result.h"
#include "core/compare/difference.h"
#include "core/compare/metric.h"

#include <optional>
#include <string>
#include <string_view>

namespace texplorer {

/// Two pictures are alike if no more than `share` of the pixels have a value above `tolerance`.
struct Criterion {
    Metric metric = Metric::Absolute;
    /// What a pixel's value may be. Absolute: of its worst component, in 255ths, 0 to 255. Ssim: 1 - SSIM at
    /// this pixel, 0 to 2. Flip: the FLIP error of this pixel, 0 to 1.
    double tolerance = factsOf(Metric::Absolute).tolerance;
    double share = 0; ///< of the pixels that count, 0 to 1
    Compared compared = Compared::Rgba;
    double pixelsPerDegree =
        67; ///< Flip: of the viewer's field of view; 67 is the paper's 0.7 m before a 4K screen

    bool operator==(const Criterion&) const = default;
};

inline constexpr double lowestPixelsPerDegree = 1;
inline constexpr double highestPixelsPerDegree = 512;

/// That metric with the tolerance of its row.
[[nodiscard]] Criterion criterionOf(Metric metric);

/// OutOfRange names what is wrong ("tolerance", "share", "pixelsPerDegree") and which values there are.
[[nodiscard]] Result<void> checkCriterion(const Criterion& criterion);

/// "0.05" or "5%" as a share of 0 to 1; a tolerance that the metric can have. All of the text is the number.
/// Errors: OutOfRange; `where` is empty.
[[nodiscard]] Result<double> parseShare(std::string_view text);
[[nodiscard]] Result<double> parseTolerance(std::string_view text, Metric metric);

} // namespace texplorer
