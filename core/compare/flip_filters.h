#pragma once

// The filters of FLIP, as products of one across and one down.

#include <vector>

namespace texplorer {

/// 2 * reach + 1 numbers, the middle one is the pixel itself.
struct FilterTaps {
    int reach;
    std::vector<float> taps;
};

/// How the eye blurs what is farther than one can resolve, an opponent channel each (section 4.1, table 1).
/// Blue-yellow is a sum of two.
struct ContrastFilters {
    FilterTaps achromatic;
    FilterTaps redGreen;
    FilterTaps blueYellow[2];
    float blueYellowShare[2]; ///< of the sum
};

[[nodiscard]] ContrastFilters contrastFilters(double pixelsPerDegree);

/// What finds edges and points (section 4.2): a Gaussian and its two derivatives, each side of which sums up
/// to 1.
struct FeatureFilters {
    FilterTaps smooth;
    FilterTaps first;
    FilterTaps second;
};

[[nodiscard]] FeatureFilters featureFilters(double pixelsPerDegree);

/// The farthest that any of them reaches.
[[nodiscard]] int flipReach(double pixelsPerDegree);

} // namespace texplorer
