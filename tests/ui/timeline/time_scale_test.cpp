#include "app/ui/timeline/time_scale.h"

#include <gtest/gtest.h>

namespace texplorer::ui::time_scale_test {
namespace {

TEST(TimeScale, PlacesAndTimesAreOneAnothersInverse) {
    const TimeScale scale{100, 400, 8};
    EXPECT_EQ(scale.xOf(0), 100);
    EXPECT_EQ(scale.xOf(2), 200);
    EXPECT_EQ(scale.timeAt(200), 2);
    EXPECT_EQ(scale.timeAt(50), 0);
    EXPECT_EQ(scale.timeAt(900), 8);
}

TEST(TimeScale, ShowsMoreThanTheLastKey) {
    EXPECT_EQ(secondsFor(0, 0), 2);
    EXPECT_EQ(secondsFor(4, 0), 5);
    EXPECT_EQ(secondsFor(4, 7.2), 8) << "the present time is in sight";
}

TEST(TimeScale, SnapsToItsGrid) {
    EXPECT_EQ(snapped(1.234F, 0.1F), 1.2F);
    EXPECT_EQ(snapped(1.234F, 0.25F), 1.25F);
    EXPECT_EQ(snapped(1.234F, 0), 1.23F);
    EXPECT_EQ(snapped(0.29F, 0.1F), 0.3F) << "and not 0.3 and a bit";
}

TEST(TimeScale, MarksHaveRoomForTheirWords) {
    EXPECT_EQ(markStep({0, 800, 8}, 60), 1);
    EXPECT_EQ(markStep({0, 800, 2}, 60), 0.2F);
    EXPECT_EQ(markStep({0, 800, 100}, 60), 10);
    EXPECT_EQ(markStep({0, 800, 0.5F}, 60), 0.1F);
}

} // namespace
} // namespace texplorer::ui::time_scale_test
