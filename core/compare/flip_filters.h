#pragma once

// The filters of FLIP, each a product of a horizontal and a vertical filter.

#include <vector>

namespace texplorer {

/// 2 * reach + 1 weights; the middle one is for the pixel itself.
struct FilterTaps {
    int reach;
    std::vector<float> taps;
};

/// The blur of the eye beyond its resolution, for each opponent channel (section 4.1, table 1). Blue-yellow
/// is a sum of two.
struct ContrastFilters {
    FilterTaps achromatic;
    FilterTaps redGreen;
    FilterTaps blueYellow[2];
    float blueYellowShare[2]; ///< of each in the sum
};

[[nodiscard]] ContrastFilters contrastFilters(double pixelsPerDegree);

/// The detectors of edges and points (section 4.2): a Gaussian and its two derivatives; each side sums to 1.
struct FeatureFilters {
    FilterTaps smooth;
    FilterTaps first;
    FilterTaps second;
};

[[nodiscard]] FeatureFilters featureFilters(double pixelsPerDegree);

/// The largest reach of the filters, in pixels.
[[nodiscard]] int flipReach(double pixelsPerDegree);

} // namespace texplorer
