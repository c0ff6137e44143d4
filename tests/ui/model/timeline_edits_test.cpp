#include "app/ui/files/scene_saving.h"
#include "app/ui/model/playback.h"
#include "app/ui/model/preview.h"
#include "app/ui/model/session.h"
#include "app/ui/model/timeline_edits.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "texplorer/scene/params/key_edits.h"
#include "texplorer/scene/params/scene_at.h"

#include <gmock/gmock.h>

namespace texplorer::ui::timeline_edits_test {
namespace {

using testing::HasSubstr;

class TimelineEdits : public testing::Test {
protected:
    TimelineEdits() { session.look.playback.playing = false; }

    [[nodiscard]] Scene& scene() { return session.document.scene; }
    [[nodiscard]] std::vector<KeyFrame>& keys() { return scene().timeline.keys; }
    /// The azimuth goes from 0 to 40 in 4 s; the scene itself says something else.
    void turn() {
        scene().view.azimuth = 99;
        keys() = {{0, "view.azimuth", "0"}, {4, "view.azimuth", "40"}};
        recordEdit(session, "Turn");
        sealEdit(session);
    }
    void at(double time) {
        session.look.playback.time = time;
        showPresent(session);
    }
    void set(const std::string& path, const std::string& value) {
        take(session, Step{.name = path, .edits = {edit::Set{path, value}}, .continues = true});
    }

    ServicesAtOnce services;
    Session session{services.lend()};
};

TEST_F(TimelineEdits, PanelsSeeTheSceneOfThePresentTime) {
    turn();
    const Scene before = scene();
    at(1);
    EXPECT_EQ(presentScene(session).view.azimuth, 10);
    EXPECT_EQ(presentScene(session).timeline, before.timeline);
    EXPECT_EQ(scene(), before);
}

TEST_F(TimelineEdits, AnEditOfWhatMovesIsAKeyAndTimeStandsStill) {
    turn();
    at(1.004);
    session.look.playback.playing = true;
    set("view.azimuth", "15");
    set("view.azimuth", "16"); // a drag goes on within the same step
    ASSERT_EQ(keys().size(), 3U);
    EXPECT_EQ(keys().back(), (KeyFrame{1, "view.azimuth", "16"}));
    EXPECT_EQ(presentScene(session).view.azimuth, 16);
    EXPECT_FALSE(session.look.playback.playing);
    EXPECT_EQ(session.look.playback.time, 1);
    EXPECT_EQ(scene(), session.document.history.current());
    EXPECT_EQ(scene().view.azimuth, 99) << "what it is without keys";
    take(session, Undo{});
    EXPECT_EQ(keys().size(), 2U);
    take(session, Redo{});
    EXPECT_EQ(keys().size(), 3U);
}

TEST_F(TimelineEdits, ADragThatIsDroppedLeavesNoKey) {
    turn();
    at(1);
    const Scene before = scene();
    set("view.azimuth", "15");
    set("view.azimuth", "16");
    take(session, DropStep{});
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(presentScene(session).view.azimuth, 10);
}

TEST_F(TimelineEdits, UndoPutsTheWholeSceneBack) {
    const Scene start = scene();
    turn();
    at(1);
    take(session, Undo{});
    EXPECT_EQ(scene(), start);
    EXPECT_EQ(presentScene(session), start);
    take(session, Redo{});
    resetToSaved(session);
    takeRequests(session);
    EXPECT_EQ(scene(), start);
}

TEST_F(TimelineEdits, AFileGetsTheSceneAndNotTheMoment) {
    const test::TempDir folder;
    turn();
    const Scene before = scene();
    at(1);
    ASSERT_TRUE(saveScene(session, folder / "scene.json"));
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(isDirty(session.document));
}

TEST_F(TimelineEdits, AVertexThatMovesIsSeen) {
    keys() = {{0, "models[0].texCoords0[3]", "0,0"}, {2, "models[0].texCoords0[3]", "1,1"}};
    recordEdit(session, "Move");
    const Scene before = scene();
    at(1);
    EXPECT_FALSE(presentScene(session).models[0].texCoords[0].empty());
    EXPECT_EQ(scene(), before);
}

TEST_F(TimelineEdits, KeysAreAddedMovedAndRemovedOneStepEach) {
    at(1.5);
    set("view.azimuth", "30");
    addKey(session, "view.azimuth", presentKeyTime(session));
    takeRequests(session);
    EXPECT_EQ(keys(), (std::vector<KeyFrame>{{1.5F, "view.azimuth", "30"}}));
    EXPECT_EQ(session.document.history.undoName(), "Add key frame");
    addKey(session, "view.azimuth", 3);
    takeRequests(session);
    EXPECT_TRUE(moveKey(session, 1, 5000));
    takeRequests(session);
    EXPECT_EQ(keys()[1].time, maxKeyTime);
    EXPECT_TRUE(moveKey(session, 1, -1));
    takeRequests(session);
    EXPECT_FALSE(moveKey(session, 1, 0));
    sealEdit(session);
    take(session, Undo{});
    EXPECT_EQ(keys()[1].time, 3) << "a drag is one step";
    setEasing(session, 1, Easing::Hold);
    takeRequests(session);
    EXPECT_EQ(keys()[1].easing, Easing::Hold);
    take(session, Undo{});
    EXPECT_EQ(keys()[1].easing, Easing::Linear);
    removeKey(session, 1);
    takeRequests(session);
    EXPECT_EQ(keys().size(), 1U);
    removeKey(session, 7);
    takeRequests(session);
    EXPECT_EQ(keys().size(), 1U);
    addKey(session, "view.nothing", 0);
    takeRequests(session);
    EXPECT_THAT(session.look.notice.text, HasSubstr("A key frame can't be added: "));
}

TEST_F(TimelineEdits, WhatLosesItsKeysStaysWhatItIs) {
    turn();
    at(1);
    removeKeys(session, "view.azimuth");
    takeRequests(session);
    EXPECT_TRUE(keys().empty());
    EXPECT_EQ(scene().view.azimuth, 10);
    EXPECT_EQ(scene(), session.document.history.current());
    take(session, Undo{});
    EXPECT_EQ(keys().size(), 2U);
    EXPECT_EQ(scene().view.azimuth, 99);
    removeKey(session, 0);
    takeRequests(session);
    removeKey(session, 0);
    takeRequests(session);
    EXPECT_EQ(scene().view.azimuth, 40);
}

TEST_F(TimelineEdits, TimeGoesFromKeyToKey) {
    turn();
    keys().push_back({2.5F, "view.elevation", "1"});
    showPresent(session);
    goToKey(session, 1);
    EXPECT_EQ(session.look.playback.time, 2.5);
    goToKey(session, 1);
    EXPECT_EQ(session.look.playback.time, 4);
    goToKey(session, 1);
    EXPECT_EQ(session.look.playback.time, 4) << "there is none behind";
    goToKey(session, -1);
    EXPECT_EQ(session.look.playback.time, 2.5);
}

TEST_F(TimelineEdits, TimeBeginsAnewBehindTheLastKey) {
    turn();
    session.look.playback.playing = true;
    at(3.5);
    advance(session, 1);
    EXPECT_DOUBLE_EQ(session.look.playback.time, 0.5);
    session.look.playback.loops = false;
    at(3.5);
    advance(session, 1);
    EXPECT_DOUBLE_EQ(session.look.playback.time, 4.5);
}

TEST_F(TimelineEdits, APreviewOfWhatMovesIsSeen) {
    turn();
    at(2);
    preview(session, "azimuth", "", [](Scene& edited) { edited.view.azimuth = 77; });
    takeRequests(session);
    EXPECT_EQ(sceneAt(shownScene(session), 2).view.azimuth, 77);
    EXPECT_EQ(keys().size(), 2U);
}

TEST_F(TimelineEdits, ASceneWithNewKeysIsUnsavedWork) {
    EXPECT_FALSE(isDirty(session.document));
    addKey(session, "view.azimuth", 0);
    takeRequests(session);
    EXPECT_TRUE(isDirty(session.document));
}

} // namespace
} // namespace texplorer::ui::timeline_edits_test
