#include "texplorer/animation/frame_times.h"

#include <gmock/gmock.h>

#include <numeric>

namespace texplorer::animation::frame_times_test {
namespace {

TEST(DurationsOf, RoundWhenEachPictureBegins) {
    // 0, 3.33, 6.67, 10, 13.33, 16.67, 20 hundredths
    EXPECT_THAT(durationsOf(6, 30, 0.2, 100), testing::ElementsAre(3, 4, 3, 3, 4, 3));
    EXPECT_THAT(durationsOf(4, 25, 0.16, 100), testing::ElementsAre(4, 4, 4, 4));
    EXPECT_THAT(durationsOf(3, 3, 1, 1000), testing::ElementsAre(333, 334, 333));
    EXPECT_THAT(durationsOf(3, 3, 1, 3), testing::ElementsAre(1, 1, 1));
}

TEST(DurationsOf, AddUpToTheWholeLength) {
    for (const double perSecond : {7.0, 12.5, 23.976, 30.0, 47.3}) {
        for (const double seconds : {0.5, 1.0, 3.7, 60.0}) {
            const auto frames = static_cast<std::size_t>(seconds * perSecond + 0.5);
            const std::vector<int> durations = durationsOf(frames, perSecond, seconds, 100);
            EXPECT_EQ(durations.size(), frames);
            EXPECT_NEAR(std::accumulate(durations.begin(), durations.end(), 0), seconds * 100, 0.5)
                << perSecond << " for " << seconds;
        }
    }
}

TEST(DurationsOf, AreNeverNothing) {
    EXPECT_THAT(durationsOf(4, 1000, 0.004, 100), testing::Each(1));
}

} // namespace
} // namespace texplorer::animation::frame_times_test
