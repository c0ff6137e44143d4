#include "app/ui/model/preview.h"
#include "app/ui/model/scene_files.h"
#include "app/ui/model/scene_saving.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "core/scene/params/key_edits.h"
#include "core/scene/params/scene_at.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

namespace texplorer::ui::timeline_edits_test {
namespace {

using testing::HasSubstr;

class TimelineEdits : public testing::Test {
protected:
    TimelineEdits() { session.window.playback.playing = false; }

    [[nodiscard]] Scene& scene() { return session.document.scene; }
    [[nodiscard]] std::vector<KeyFrame>& keys() { return scene().timeline.keys; }
    /// The azimuth goes from 0 to 40 in 4 s; the scene itself says something else.
    void turn() {
        scene().view.azimuth = 99;
        keys() = {{0, "view.azimuth", "0"}, {4, "view.azimuth", "40"}};
        recordScene(session, "Turn");
        sealEdit(session);
    }
    void at(double time) { session.window.playback.time = time; }

    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(TimelineEdits, PanelsSeeTheSceneOfThePresentTime) {
    turn();
    at(1);
    const Scene before = scene();
    beginStanding(session);
    EXPECT_EQ(scene().view.azimuth, 10);
    EXPECT_EQ(scene().timeline, before.timeline);
    endStanding(session);
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(scene(), session.document.history.current());
}

TEST_F(TimelineEdits, AnEditOfWhatMovesIsAKeyAndTimeStandsStill) {
    turn();
    at(1.004);
    session.window.playback.playing = true;
    beginStanding(session);
    scene().view.azimuth += 5;
    recordEdit(session, "Azimuth", "view.azimuth");
    scene().view.azimuth += 1; // a drag goes on within the same step
    recordEdit(session, "Azimuth", "view.azimuth");
    endStanding(session);
    ASSERT_EQ(keys().size(), 3U);
    EXPECT_EQ(keys().back().time, 1.0F);
    EXPECT_NEAR(sceneAt(scene(), 1).view.azimuth, 16.04F, 1e-4F);
    EXPECT_FALSE(session.window.playback.playing);
    EXPECT_EQ(session.window.playback.time, 1);
    EXPECT_EQ(scene(), session.document.history.current());
    EXPECT_EQ(scene().view.azimuth, 99) << "what it is without keys";
    undo(session);
    EXPECT_EQ(keys().size(), 2U);
    redo(session);
    EXPECT_EQ(keys().size(), 3U);
}

TEST_F(TimelineEdits, WhatHasNoKeysIsEditedAsEver) {
    turn();
    at(1);
    beginStanding(session);
    scene().textures[0].wrapS = Wrap::Clamp;
    recordEdit(session, "Wrap", "textures[0].wrapS");
    endStanding(session);
    EXPECT_EQ(keys().size(), 2U);
    EXPECT_EQ(scene().textures[0].wrapS, Wrap::Clamp);
    EXPECT_EQ(scene().view.azimuth, 99);
}

TEST_F(TimelineEdits, AnEditOutsideThePanelsIsAKeyToo) {
    turn();
    at(2);
    scene().view.azimuth = 7; // as a key that resets the camera
    recordEdit(session, "Reset camera");
    ASSERT_EQ(keys().size(), 3U);
    EXPECT_EQ(keys().back(), (KeyFrame{2, "view.azimuth", "7"}));
}

TEST_F(TimelineEdits, UndoWhilePanelsAreDrawnPutsTheWholeSceneBack) {
    const Scene start = scene();
    turn();
    at(1);
    beginStanding(session);
    undo(session);
    endStanding(session);
    EXPECT_EQ(scene(), start);
    redo(session);
    beginStanding(session);
    resetToSaved(session);
    endStanding(session);
    EXPECT_EQ(scene(), start);
}

TEST_F(TimelineEdits, AFileGetsTheSceneAndNotTheMoment) {
    const test::TempDir folder;
    turn();
    const Scene before = scene();
    at(1);
    beginStanding(session);
    ASSERT_TRUE(saveScene(session, folder / "scene.json"));
    endStanding(session);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(isDirty(session.document));
}

TEST_F(TimelineEdits, AVertexThatMovesLeavesTheSceneAsItWas) {
    keys() = {{0, "models[0].texCoords0[3]", "0,0"}, {2, "models[0].texCoords0[3]", "1,1"}};
    recordScene(session, "Move");
    at(1);
    const Scene before = scene();
    beginStanding(session);
    EXPECT_FALSE(scene().models[0].texCoords[0].empty());
    endStanding(session);
    EXPECT_EQ(scene(), before);
}

TEST_F(TimelineEdits, KeysAreAddedMovedAndRemovedOneStepEach) {
    at(1.5);
    scene().view.azimuth = 30;
    recordEdit(session, "Azimuth");
    addKey(session, "view.azimuth", presentKeyTime(session));
    EXPECT_EQ(keys(), (std::vector<KeyFrame>{{1.5F, "view.azimuth", "30"}}));
    EXPECT_EQ(session.document.history.undoName(), "Add key frame");
    addKey(session, "view.azimuth", 3);
    EXPECT_TRUE(moveKey(session, 1, 5000));
    EXPECT_EQ(keys()[1].time, maxKeyTime);
    EXPECT_TRUE(moveKey(session, 1, -1));
    EXPECT_FALSE(moveKey(session, 1, 0));
    sealEdit(session);
    undo(session);
    EXPECT_EQ(keys()[1].time, 3) << "a drag is one step";
    setEasing(session, 1, Easing::Hold);
    EXPECT_EQ(keys()[1].easing, Easing::Hold);
    undo(session);
    EXPECT_EQ(keys()[1].easing, Easing::Linear);
    removeKey(session, 1);
    EXPECT_EQ(keys().size(), 1U);
    removeKey(session, 7);
    EXPECT_EQ(keys().size(), 1U);
    addKey(session, "view.nothing", 0);
    EXPECT_THAT(session.window.notice.text, HasSubstr("A key frame can't be added: "));
}

TEST_F(TimelineEdits, WhatLosesItsKeysStaysWhatItIs) {
    turn();
    at(1);
    beginStanding(session);
    removeKeys(session, "view.azimuth");
    endStanding(session);
    EXPECT_TRUE(keys().empty());
    EXPECT_EQ(scene().view.azimuth, 10);
    EXPECT_EQ(scene(), session.document.history.current());
    undo(session);
    EXPECT_EQ(keys().size(), 2U);
    EXPECT_EQ(scene().view.azimuth, 99);
    removeKey(session, 0); // outside of the panels
    removeKey(session, 0);
    EXPECT_EQ(scene().view.azimuth, 40);
}

TEST_F(TimelineEdits, TimeGoesFromKeyToKey) {
    turn();
    keys().push_back({2.5F, "view.elevation", "1"});
    goToKey(session, 1);
    EXPECT_EQ(session.window.playback.time, 2.5);
    goToKey(session, 1);
    EXPECT_EQ(session.window.playback.time, 4);
    goToKey(session, 1);
    EXPECT_EQ(session.window.playback.time, 4) << "there is none behind";
    goToKey(session, -1);
    EXPECT_EQ(session.window.playback.time, 2.5);
}

TEST_F(TimelineEdits, TimeBeginsAnewBehindTheLastKey) {
    turn();
    session.window.playback.playing = true;
    at(3.5);
    advance(session, 1);
    EXPECT_DOUBLE_EQ(session.window.playback.time, 0.5);
    session.window.playback.loops = false;
    at(3.5);
    advance(session, 1);
    EXPECT_DOUBLE_EQ(session.window.playback.time, 4.5);
}

TEST_F(TimelineEdits, APreviewOfWhatMovesIsSeen) {
    turn();
    at(2);
    beginStanding(session);
    preview(session, "azimuth", "", [](Scene& edited) { edited.view.azimuth = 77; });
    endStanding(session);
    EXPECT_EQ(sceneAt(shownScene(session), 2).view.azimuth, 77);
    EXPECT_EQ(keys().size(), 2U);
}

TEST_F(TimelineEdits, ASceneWithNewKeysIsUnsavedWork) {
    EXPECT_FALSE(isDirty(session.document));
    addKey(session, "view.azimuth", 0);
    EXPECT_TRUE(isDirty(session.document));
}

TEST_F(TimelineEdits, NoMoreKeysThanThereMayBe) {
    keys().assign(maxKeyFrames, {0, "view.azimuth", "1"});
    recordScene(session, "Many");
    at(1);
    beginStanding(session);
    scene().view.azimuth = 50;
    recordEdit(session, "Azimuth");
    endStanding(session);
    EXPECT_THAT(session.window.notice.text, HasSubstr("at most 1024 key frames"));
    EXPECT_EQ(scene().timeline.keys.size(), maxKeyFrames);
}

} // namespace
} // namespace texplorer::ui::timeline_edits_test
