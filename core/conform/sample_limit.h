#pragma once

namespace texplorer::conform {

/// The probability that a sample of scenes exceeds its limit although the renderer obeys the rule.
inline constexpr double falseAlarms = 1e-4;

/// The shares of pixels in a sample's scenes.
struct Sample {
    int scenes = 0;
    double deviation = 0; ///< the standard deviation of the shares
    double max = 1;       ///< the maximum for a single scene
};

/// Returns the largest allowed mean of a sample if `allowed` is the mean of all possible scenes: a rule's
/// shares hold for thousands of scenes, the mean of a few scatters more. A share of 0 allows none in any
/// sample. The result is the lower of two bounds:
///
/// Wassily Hoeffding, "Probability Inequalities for Sums of Bounded Random Variables", 1963, theorem 1, for
/// any shares from 0 to `max`: with p = allowed / max and q = mean / max,
///     P <= exp(-n (q log(q / p) + (1 - q) log((1 - q) / (1 - p)))).
///
/// Bradley Efron, "Student's t-Test under Symmetry Conditions", 1969, section 2: with S the sum of x -
/// allowed over n scenes and V^2 the sum of its squares, P(S >= c V) <= exp(-c^2 / 2) if x is symmetric about
/// `allowed`; shares with their tail above it exceed it less often. V^2 is n (deviation^2 + (mean -
/// allowed)^2), which gives the mean. It bounds nothing for up to 18 scenes.
[[nodiscard]] double sampleLimit(double allowed, const Sample& sample);

/// Whether a sample is so small that an excess may be chance.
[[nodiscard]] bool areFewScenes(int scenes);

} // namespace texplorer::conform
