#include "texplorer/scene/animation.h"
#include "texplorer/scene/timeline.h"

#include <gtest/gtest.h>

namespace texplorer::timeline_test {
namespace {

struct Way {
    Easing easing;
    double share;
    double done;
};

// t, t^2, 1 - (1 - t)^2 and 3 t^2 - 2 t^3 by hand.
TEST(Eased, IsWhatTheFormulasSay) {
    for (const auto& [easing, share, done] :
         {Way{Easing::Hold, 0, 0}, Way{Easing::Hold, 0.999, 0}, Way{Easing::Hold, 1, 1},
          Way{Easing::Linear, 0.25, 0.25}, Way{Easing::Linear, 0.7, 0.7}, Way{Easing::EaseIn, 0.25, 0.0625},
          Way{Easing::EaseIn, 0.5, 0.25}, Way{Easing::EaseOut, 0.25, 0.4375}, Way{Easing::EaseOut, 0.5, 0.75},
          Way{Easing::EaseInOut, 0.25, 0.15625}, Way{Easing::EaseInOut, 0.5, 0.5}})
        EXPECT_DOUBLE_EQ(eased(easing, share), done) << rowOf(easing).name << " at " << share;
}

TEST(Eased, BeginsAtNothingEndsAtAllAndNeverTurnsBack) {
    for (const EnumRow& row : easingRows) {
        const auto easing = static_cast<Easing>(row.value);
        EXPECT_EQ(eased(easing, 0), 0) << row.name;
        EXPECT_EQ(eased(easing, 1), 1) << row.name;
        EXPECT_EQ(eased(easing, -5), 0) << row.name;
        EXPECT_EQ(eased(easing, 5), 1) << row.name;
        for (int i = 0; i < 1000; ++i)
            EXPECT_LE(eased(easing, i / 1000.0), eased(easing, (i + 1) / 1000.0)) << row.name << i;
    }
}

TEST(Tracks, HaveTheKeysOfAParameterByTheirTime) {
    const Timeline timeline{{{2, "b", "1"}, {1, "a", "2"}, {0, "b", "3"}, {2, "b", "4"}}};
    const std::vector<Track> tracks = tracksOf(timeline);
    ASSERT_EQ(tracks.size(), 2U);
    EXPECT_EQ(tracks[0].path, "b");
    ASSERT_EQ(tracks[0].keys.size(), 3U);
    EXPECT_EQ(tracks[0].keys[0]->value, "3");
    EXPECT_EQ(tracks[0].keys[1]->value, "1") << "those at the same time in their order";
    EXPECT_EQ(tracks[0].keys[2]->value, "4");
    EXPECT_EQ(tracks[1].path, "a");
}

struct Then {
    double time;
    const char* from;
    const char* to; ///< nullptr: none
    double share;
};

TEST(Moments, LieBetweenTwoKeys) {
    // A jump from b to c at 3 s.
    const Timeline timeline{
        {{1, "x", "a"}, {3, "x", "b", Easing::EaseIn}, {3, "x", "c", Easing::EaseIn}, {5, "x", "d"}}};
    const Track track = tracksOf(timeline).front();
    for (const Then& then : {Then{-1, "a", nullptr, 0}, Then{0, "a", nullptr, 0}, Then{1, "a", "b", 0},
                             Then{2, "a", "b", 0.5}, Then{3, "c", "d", 0}, Then{4, "c", "d", 0.25},
                             Then{5, "d", nullptr, 0}, Then{1e9, "d", nullptr, 0}}) {
        const Moment moment = momentOf(track, then.time);
        EXPECT_EQ(moment.from->value, then.from) << then.time;
        EXPECT_EQ(moment.to != nullptr, then.to != nullptr) << then.time;
        if (moment.to && then.to) {
            EXPECT_EQ(moment.to->value, then.to) << then.time;
        }
        EXPECT_DOUBLE_EQ(moment.share, then.share) << then.time;
    }
}

TEST(Timelines, KnowWhetherAndHowLongTheyMove) {
    EXPECT_FALSE(isMoving(Timeline{}));
    EXPECT_EQ(lengthOf(Timeline{}), 0);
    EXPECT_FALSE(isMoving(Timeline{{{0, "x", "1"}, {4, "x", "1"}, {2, "y", "2"}}}))
        << "each stays what it is";
    EXPECT_TRUE(isMoving(Timeline{{{4, "x", "1"}, {0, "x", "2"}}}));
    EXPECT_EQ(lengthOf(Timeline{{{4, "x", "1"}, {0, "x", "2"}}}), 4);
    Scene scene;
    EXPECT_FALSE(isAnimated(scene));
    scene.timeline.keys = {{0, "view.azimuth", "0"}, {1, "view.azimuth", "9"}};
    EXPECT_TRUE(isAnimated(scene));
}

} // namespace
} // namespace texplorer::timeline_test
