#include "app/ui/model/timeline_edits.h"
#include "app/ui/timeline/timeline_tab.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/drawn_texts.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/scene/params/scene_at.h"

namespace texplorer::ui::timeline_tab_test {
namespace {

using namespace test;

class TimelineTab : public Workbench {
protected:
    TimelineTab() {
        session->look.playback.playing = false;
        openTab();
    }

    void openTab() {
        session->window.wantedTab = Tab::Timeline;
        frames(3);
    }
    [[nodiscard]] std::vector<KeyFrame>& keys() { return scene().timeline.keys; }
    void turn() {
        keys() = {{0, "view.azimuth", "0"}, {4, "view.azimuth", "40"}};
        recordEdit(*session, "Turn");
        sealEdit(*session);
        frames(2);
    }
    /// Where a time lies in a row, between two keys of it whose places are known.
    [[nodiscard]] ImVec2 placeAt(float time) {
        const ImVec2 first = place("key:view.azimuth@0");
        const ImVec2 last = place("key:view.azimuth@4");
        return {first.x + (last.x - first.x) * time / 4, first.y};
    }
};

TEST_F(TimelineTab, IsOpenedBesideTheClockSaysHowItBeginsAndLeadsToTheRecording) {
    session->window.wantedTab = Tab::Commands;
    frames(3);
    click("timeline");
    frames(3);
    EXPECT_TRUE(has("timeline:empty"));
    turn();
    EXPECT_FALSE(has("timeline:empty"));
    EXPECT_TRUE(has("track:view.azimuth"));
    EXPECT_TRUE(has("key:view.azimuth@4"));
    click("timeline:record");
    EXPECT_EQ(session->asking.dialog, Dialog::Record);
}

TEST_F(TimelineTab, NamesOfTracksBeginWithWhatDiffers) {
    unit().matrix = {{.op = MatrixOp::Translate}, {.op = MatrixOp::Translate}};
    for (const char* path : {"passes[0].units[0].matrix[0].amount", "passes[0].units[0].matrix[1].amount"})
        keys().insert(keys().end(), {{0, path, "0,0,0"}, {1, path, "1,0,0"}});
    for (const char* path : {"light.ambient", "material.ambient", "view.azimuth"})
        keys().push_back({0, path, path == std::string("view.azimuth") ? "0" : "0,0,0,1"});
    recordEdit(*session, "Move");
    frames(2);
    const std::vector<std::string> texts = drawnTexts();
    for (const char* name : {"matrix[0]: Amount", "matrix[1]: Amount", "Azimuth"})
        EXPECT_THAT(texts, testing::Contains(name));
}

TEST_F(TimelineTab, HasSomethingToBeginWith) {
    for (const float azimuth : {-30.0F, 40.0F}) {
        scene().view.azimuth = azimuth;
        recordEdit(*session, "Azimuth");
        sealEdit(*session);
        frames(2);
        click("timeline:turn");
        ASSERT_EQ(keys().size(), 2U);
        EXPECT_TRUE(session->look.playback.playing);
        EXPECT_NEAR(sceneAt(scene(), 0).view.azimuth, azimuth, 0.001F);
        const float half = sceneAt(scene(), 2).view.azimuth - azimuth;
        EXPECT_NEAR(std::abs(half), 180, 0.001F);
        EXPECT_NEAR(sceneAt(scene(), 4).view.azimuth - azimuth, 2 * half, 0.001F);
        key('Z', {ctrl});
        EXPECT_TRUE(has("timeline:empty")) << "one step";
        EXPECT_EQ(scene().view.azimuth, azimuth);
    }
}

TEST_F(TimelineTab, AParametersMenuAddsAKeyAtThisTime) {
    session->look.playback.time = 1.5;
    open("Texture");
    scrollTo("textures[0].lodBias#label");
    click("textures[0].lodBias#label", ImGuiMouseButton_Right);
    click("textures[0].lodBias#menu:key");
    ASSERT_EQ(keys().size(), 1U);
    EXPECT_EQ(keys()[0], (KeyFrame{1.5F, "textures[0].lodBias", "0"}));
    EXPECT_TRUE(has("textures[0].lodBias#key")) << "its label has a diamond";
    session->look.playback.time = 3;
    frames(2);
    click("textures[0].lodBias#key");
    EXPECT_EQ(keys().size(), 2U);
    click("textures[0].lodBias#key");
    EXPECT_EQ(keys().size(), 1U) << "the one of this time";
    take(*session, Undo{});
    take(*session, Undo{});
    take(*session, Undo{});
    EXPECT_TRUE(keys().empty());
}

TEST_F(TimelineTab, AKeyIsDraggedInTimeInOneStep) {
    turn();
    const std::size_t step = session->document.history.position();
    const ImVec2 from = place("key:view.azimuth@4");
    drag(from, {placeAt(2.03F).x - from.x, 0});
    EXPECT_EQ(keys()[1].time, 2) << "it comes to the grid";
    EXPECT_EQ(session->look.playback.time, 2);
    EXPECT_EQ(session->document.history.position(), step + 1);
    take(*session, Undo{});
    EXPECT_EQ(keys()[1].time, 4);
}

TEST_F(TimelineTab, AClickChoosesAKeyAndItsControlsChangeIt) {
    turn();
    click("key:view.azimuth@4");
    EXPECT_EQ(session->look.playback.time, 4);
    click("key:easing");
    click("easing:ease-in-out");
    EXPECT_EQ(keys()[1].easing, Easing::EaseInOut);
    doubleClickAt(place("key:time"));
    key('A', {ctrl});
    type("3.25");
    key(key::enter);
    EXPECT_EQ(keys()[1].time, 3.25F);
    click("key:remove");
    EXPECT_EQ(keys().size(), 1U);
    EXPECT_FALSE(has("key:remove"));
}

TEST_F(TimelineTab, KeysOfTheKeyboardMoveAndRemove) {
    turn();
    click("key:view.azimuth@4");
    key(key::left);
    EXPECT_EQ(keys()[1].time, 3.9F);
    EXPECT_EQ(session->look.playback.time, double{3.9F}) << "the clock follows";
    key(key::right);
    EXPECT_EQ(keys()[1].time, 4);
    key(',');
    EXPECT_EQ(session->look.playback.time, 0);
    key('.');
    EXPECT_EQ(session->look.playback.time, 4);
    key(key::del);
    EXPECT_EQ(keys().size(), 1U);
    take(*session, Undo{});
    EXPECT_EQ(keys().size(), 2U);
}

TEST_F(TimelineTab, AMenuHasEasingsAndRemoves) {
    turn();
    click("key:view.azimuth@0", ImGuiMouseButton_Right);
    click("key menu:hold");
    EXPECT_EQ(keys()[0].easing, Easing::Hold);
    click("track:view.azimuth", ImGuiMouseButton_Right);
    click("track menu:remove");
    EXPECT_TRUE(keys().empty());
    EXPECT_TRUE(has("timeline:empty"));
}

TEST_F(TimelineTab, MenusOpenByTheKeyboard) {
    turn();
    click("key:view.azimuth@0");
    key(key::menu);
    EXPECT_TRUE(has("key menu:hold"));
    key(key::escape);
    open("Texture");
    scrollTo("textures[0].lodBias");
    click("textures[0].lodBias");
    key(key::f10, {shift});
    EXPECT_TRUE(has("textures[0].lodBias#menu:key"));
}

TEST_F(TimelineTab, ADoubleClickAddsAKey) {
    turn();
    doubleClickAt(placeAt(1));
    ASSERT_EQ(keys().size(), 3U);
    EXPECT_EQ(keys()[2], (KeyFrame{1, "view.azimuth", "10"})) << "what it is then";
}

TEST_F(TimelineTab, TheRulerMovesTheTimeAndThePanelsFollow) {
    turn();
    clickAt({placeAt(2).x, place("timeline:ruler").y});
    EXPECT_EQ(session->look.playback.time, 2);
    EXPECT_EQ(scene(), session->document.history.current()) << "the scene itself stays";
    click("timeline:next");
    EXPECT_EQ(session->look.playback.time, 4);
    click("timeline:previous");
    EXPECT_EQ(session->look.playback.time, 0);
}

TEST_F(TimelineTab, TurningTheCameraByTheMouseIsAKey) {
    const float start = scene().view.azimuth;
    drag(place("view"), {-50, 0});
    const float way = scene().view.azimuth - start;
    turn();
    session->look.playback.time = 2;
    frames(2);
    drag(place("view"), {-50, 0});
    ASSERT_EQ(keys().size(), 3U);
    EXPECT_EQ(keys()[2].time, 2);
    EXPECT_NEAR(sceneAt(scene(), 2).view.azimuth, 20 + way, 1e-3F) << "from where it is then";
    EXPECT_EQ(scene(), session->document.history.current());
}

TEST_F(TimelineTab, StandsInEverySizeWithManyTracks) {
    Scene crowded = defaultScene();
    forEachParam(crowded, [&](const std::string& path, const ParamRow& row, const Value& value) {
        if (crowded.timeline.keys.size() < 200 && row.kind != Kind::Text)
            crowded.timeline.keys.push_back(
                {static_cast<float>(crowded.timeline.keys.size() % 7), path, formatValue(row, value)});
    });
    for (const float scale : {0.75F, 1.0F, 2.5F}) {
        start(crowded, 1024, 700, scale);
        for (const Dock dock : {Dock::Right, Dock::Below}) {
            moveTab(session->settings.workspace, Tab::Timeline, dock);
            openTab();
            expectSoundFrame();
        }
    }
}

} // namespace
} // namespace texplorer::ui::timeline_tab_test
