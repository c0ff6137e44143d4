#pragma once

namespace texplorer::conform {

/// How likely a sample of scenes goes beyond its limit where its renderer keeps to what is allowed.
inline constexpr double falseAlarms = 1e-4;

/// The shares of pixels that a sample's scenes have.
struct Sample {
    int scenes = 0;
    double deviation = 0; ///< the standard deviation of the shares
    double most = 1;      ///< what no single scene may exceed
};

/// What the mean of a sample may be where `allowed` is the mean of all scenes that there could be: a rule's
/// shares hold for thousands of scenes, those of a few are further apart. A share of 0 allows none in any
/// sample. The lower of two bounds:
///
/// Wassily Hoeffding, "Probability Inequalities for Sums of Bounded Random Variables", 1963, theorem 1, for
/// any shares from 0 to `most`: with p = allowed / most and q = mean / most,
///     P <= exp(-n (q log(q / p) + (1 - q) log((1 - q) / (1 - p)))).
///
/// Bradley Efron, "Student's t-Test under Symmetry Conditions", 1969, section 2: with S the sum of
/// x - allowed over n scenes and V^2 the sum of its squares, P(S >= c V) <= exp(-c^2 / 2) where x is
/// symmetric about `allowed`; shares that have their tail above exceed it less often. V^2 is n (deviation^2 +
/// (mean - allowed)^2), which leaves the mean. It says nothing of up to 18 scenes.
[[nodiscard]] double sampleLimit(double allowed, const Sample& sample);

/// So few scenes tell little: more than is allowed may be chance.
[[nodiscard]] bool areFewScenes(int scenes);

} // namespace texplorer::conform
