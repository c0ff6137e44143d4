#include "texplorer/conform/sample_limit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texplorer::conform::sample_limit_test {
namespace {

/// The probability of k successes in n trials.
double binomial(int n, int k, double p) {
    return std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(p) +
                    (n - k) * std::log1p(-p));
}

/// How often a sample goes beyond its limit whose scenes have a share of `high` with probability p, else
/// `low`: the binomial distribution, exactly.
double falseAlarmsOf(int scenes, double low, double high, double p, double most = 1) {
    const double allowed = p * high + (1 - p) * low;
    double sum = 0;
    for (int k = 0; k <= scenes; ++k) {
        const double part = static_cast<double>(k) / scenes;
        const double mean = part * high + (1 - part) * low;
        const double deviation = (high - low) * std::sqrt(part * (1 - part));
        if (mean > sampleLimit(allowed, {scenes, deviation, most}))
            sum += binomial(scenes, k, p);
    }
    return sum;
}

TEST(SampleLimit, IsKeptByChance) {
    for (int scenes = 1; scenes <= 500; ++scenes) {
        EXPECT_LT(falseAlarmsOf(scenes, 0.02, 0.06, 0.5), falseAlarms) << scenes; // symmetric
        EXPECT_LT(falseAlarmsOf(scenes, 0, 0.6, 0.2), falseAlarms) << scenes;     // a few have most of it
        EXPECT_LT(falseAlarmsOf(scenes, 0, 1, 0.04), falseAlarms) << scenes;
        EXPECT_LT(falseAlarmsOf(scenes, 0, 0.01, 0.05, 0.01), falseAlarms) << scenes;
    }
}

// It is there to be exceeded: of as many scenes as there are, a third more than is allowed is found nearly
// always.
TEST(SampleLimit, FindsWhatIsMore) {
    const auto found = [](int scenes, double p, double allowed) {
        double sum = 0;
        for (int k = 0; k <= scenes; ++k) {
            const double part = static_cast<double>(k) / scenes;
            const double deviation = 0.08 * std::sqrt(part * (1 - part));
            if (0.08 * part > sampleLimit(allowed, {scenes, deviation, 1}))
                sum += binomial(scenes, k, p);
        }
        return sum;
    };
    EXPECT_GT(found(300, 0.67, 0.04), 0.9); // 5.4 % where 4 % are allowed
    EXPECT_GT(found(80, 0.9, 0.04), 0.99);  // 7.2 %
}

// Hoeffding's bound for a mean of 1 / 2: n scenes of which each is 1, exactly 2^-n.
TEST(SampleLimit, FollowsTheInequalities) {
    EXPECT_GT(sampleLimit(0.5, {13, 0.5, 1}), 0.999);
    EXPECT_LE(sampleLimit(0.5, {13, 0.5, 1}), 1);     // 2^-13 = 1.2e-4
    EXPECT_LT(sampleLimit(0.5, {14, 0.5, 1}), 0.999); // 2^-14 = 0.6e-4
    // 0.04 + 0.03 sqrt(2 log(10000) / (64 - 2 log(10000)))
    EXPECT_NEAR(sampleLimit(0.04, {64, 0.03, 1}), 0.0590709, 1e-6);
    EXPECT_EQ(sampleLimit(0.04, {19, 0, 1}), 0.04);
    EXPECT_TRUE(areFewScenes(18));
    EXPECT_FALSE(areFewScenes(19));
}

TEST(SampleLimit, IsNothingWhereNothingIsAllowed) {
    for (const int scenes : {1, 18, 1000})
        EXPECT_EQ(sampleLimit(0, {scenes, 0.5, 1}), 0);
}

} // namespace
} // namespace texplorer::conform::sample_limit_test
