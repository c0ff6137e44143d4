#include "texplorer/compare/paired_times.h"

#include <gtest/gtest.h>

namespace texplorer::paired_times_test {
namespace {

TEST(PairedTimes, QuartilesAreThoseOfNumPy) {
    // numpy.percentile([...], [25, 50, 75]), and by hand: places 0.75, 1.5 and 2.25 of four sorted numbers.
    EXPECT_EQ(quartilesOf({4, 1, 3, 2}), (Quartiles{1.75, 2.5, 3.25}));
    EXPECT_EQ(quartilesOf({10, 0, 20, 40, 30}), (Quartiles{10, 20, 30}));
    EXPECT_EQ(quartilesOf({7}), (Quartiles{7, 7, 7}));
    EXPECT_EQ(quartilesOf({}), Quartiles{});
}

TEST(PairedTimes, TheRatioIsThatOfEachPair) {
    // While both take twice as long, their ratio stays.
    const TimeComparison compared = compareTimes({{1, 2, 4, 8}, {3, 6, 12, 24}});
    EXPECT_EQ(compared.a, (Quartiles{1.75, 3, 5}));
    EXPECT_EQ(compared.b, (Quartiles{5.25, 9, 15}));
    EXPECT_EQ(compared.ratio, (Quartiles{3, 3, 3}));
    EXPECT_EQ(compared.pairs, 4U);
}

TEST(PairedTimes, PairsWithoutATimeHaveNoRatio) {
    const TimeComparison compared = compareTimes({{0, 2, 1}, {1, 1, 0, 5}});
    EXPECT_EQ(compared.pairs, 1U);
    EXPECT_EQ(compared.ratio, (Quartiles{0.5, 0.5, 0.5}));
    EXPECT_EQ(compareTimes({}).pairs, 0U);
}

/// A takes 1; B takes 2 in the first `slower` pairs, and 0.5 in the others.
TimeComparison mixed(std::size_t pairs, std::size_t slower) {
    PairedTimes times{std::vector<double>(pairs, 1), std::vector<double>(pairs, 0.5)};
    std::fill_n(times.b.begin(), slower, 2);
    return compareTimes(times);
}

TEST(PairedTimes, DifferIfThreeQuartersOfEnoughPairsDo) {
    EXPECT_TRUE(mixed(20, 20).differs);
    EXPECT_TRUE(mixed(20, 15).differs);
    EXPECT_FALSE(mixed(20, 14).differs);
    EXPECT_FALSE(mixed(20, 6).differs);
    EXPECT_TRUE(mixed(20, 5).differs) << "B is faster";
    EXPECT_FALSE(mixed(19, 19).differs) << "too few";
}

} // namespace
} // namespace texplorer::paired_times_test
