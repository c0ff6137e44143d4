#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_at.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::key_edits_test {
namespace {

using testing::HasSubstr;

TEST(PutKey, AddsOneOrChangesTheOneThatIsThere) {
    Scene scene = defaultScene();
    EXPECT_EQ(putKey(scene, "view.azimuth", 1, "10").value(), 0U);
    EXPECT_EQ(putKey(scene, "view.azimuth", 3, "30").value(), 1U);
    EXPECT_EQ(putKey(scene, "view.azimuth", 1, "20").value(), 0U);
    EXPECT_EQ(scene.timeline.keys,
              (std::vector<KeyFrame>{{1, "view.azimuth", "20"}, {3, "view.azimuth", "30"}}));
    EXPECT_TRUE(hasKeys(scene.timeline, "view.azimuth"));
    EXPECT_FALSE(hasKeys(scene.timeline, "view.elevation"));
    EXPECT_EQ(keyAt(scene.timeline, "view.azimuth", 3), 1U);
    EXPECT_FALSE(keyAt(scene.timeline, "view.azimuth", 2));
    EXPECT_FALSE(keyAt(scene.timeline, "view.elevation", 3));
}

TEST(PutKey, BetweenTwoGoesOnAsTheOneBefore) {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "0", Easing::EaseIn}, {4, "view.azimuth", "40", Easing::Hold}};
    const std::size_t added = putKey(scene, "view.azimuth", 2, "10").value();
    EXPECT_EQ(scene.timeline.keys[added].easing, Easing::EaseIn);
    EXPECT_EQ(scene.timeline.keys[putKey(scene, "view.azimuth", 4, "44").value()].easing, Easing::Hold)
        << "one that is changed keeps its own";
    EXPECT_EQ(scene.timeline.keys[putKey(scene, "view.elevation", 2, "10").value()].easing, Easing::Linear);
}

TEST(PutKey, RefusesWhatCantBeAndChangesNothing) {
    Scene scene = defaultScene();
    const auto refused = [&](std::string_view path, float time, std::string_view value) {
        const Result<std::size_t> put = putKey(scene, path, time, value);
        return put ? std::string("nothing") : put.error().message.english();
    };
    EXPECT_THAT(refused("view.azimut", 0, "1"), HasSubstr("view"));
    EXPECT_THAT(refused("view.azimuth", 0, "north"), HasSubstr("north"));
    EXPECT_THAT(refused("view.azimuth", -1, "1"), HasSubstr("from 0 to 3600 s"));
    EXPECT_THAT(refused("view.azimuth", 3601, "1"), HasSubstr("from 0 to 3600 s"));
    EXPECT_EQ(scene, defaultScene());
    scene.timeline.keys.assign(maxKeyFrames, {0, "view.azimuth", "1"});
    EXPECT_THAT(refused("view.azimuth", 1, "1"), HasSubstr("at most 1024 key frames"));
    EXPECT_EQ(refused("view.azimuth", 0, "2"), "nothing") << "the last of those is changed";
    EXPECT_EQ(scene.timeline.keys.back().value, "2");
}

TEST(KeyEdits, OfWhatHasKeysAreKeys) {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "0"}, {4, "view.azimuth", "40"}};
    const Scene before = scene;
    scene.view.azimuth = 25;
    scene.view.elevation = 60; // which has none
    EXPECT_TRUE(keyEdits(scene, before, 1).value());
    EXPECT_EQ(scene.timeline.keys.size(), 3U);
    EXPECT_EQ(scene.timeline.keys.back(), (KeyFrame{1, "view.azimuth", "25"}));
    EXPECT_EQ(sceneAt(scene, 1).view.azimuth, 25);
    EXPECT_FALSE(keyEdits(scene, scene, 2).value()) << "nothing was edited";
}

TEST(KeyEdits, LeaveTheTimelineAloneWhereItWasEdited) {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "0"}};
    const Scene before = scene;
    scene.timeline.keys.front().time = 2;
    scene.view.azimuth = 25;
    EXPECT_FALSE(keyEdits(scene, before, 1).value());
    EXPECT_EQ(scene.timeline.keys.size(), 1U);
}

TEST(PutUnkeyed, LeavesWhatHasNoKeys) {
    Scene scene = defaultScene();
    scene.timeline.keys = {{0, "view.azimuth", "7"}, {0, "textures[0].wrapS", "GL_CLAMP"}};
    const Scene base = scene;
    Scene standing = sceneAt(scene, 0);
    standing.timeline = scene.timeline;
    standing.view.elevation = 3;
    putUnkeyed(standing, base);
    EXPECT_EQ(standing.view.azimuth, base.view.azimuth);
    EXPECT_EQ(standing.textures[0].wrapS, base.textures[0].wrapS);
    EXPECT_EQ(standing.view.elevation, 3);
}

TEST(DropKeys, LeavesThoseOfOthers) {
    Timeline timeline{{{0, "view.azimuth", "7"}, {0, "view.elevation", "1"}, {2, "view.azimuth", "8"}}};
    dropKeys(timeline, "view.azimuth");
    EXPECT_EQ(timeline.keys, (std::vector<KeyFrame>{{0, "view.elevation", "1"}}));
}

} // namespace
} // namespace texplorer::key_edits_test
