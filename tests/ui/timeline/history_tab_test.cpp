#include "app/ui/model/kept.h"
#include "app/ui/timeline/history_tab.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"

#include <gmock/gmock.h>

namespace texplorer::ui::history_tab_test {
namespace {

using namespace test;

class HistoryTab : public Workbench {
protected:
    HistoryTab() {
        session->window.wantedTab = Tab::History;
        frames(2);
    }
    void edit(Pattern pattern, std::string_view name) {
        texture().pattern = pattern;
        recordEdit(*session, name);
        sealEdit(*session);
        frames(1);
    }
    [[nodiscard]] const History& history() const { return session->document.history; }
};

TEST_F(HistoryTab, GoesToTheStepThatIsClicked) {
    edit(Pattern::Brick, "Brick");
    edit(Pattern::Tree, "Tree");
    edit(Pattern::Planet, "Planet");
    click("history:1");
    EXPECT_EQ(texture().pattern, Pattern::Brick);
    EXPECT_EQ(history().redoName(), "Tree");
    click("history:3");
    EXPECT_EQ(texture().pattern, Pattern::Planet);
    click("history:0");
    EXPECT_EQ(texture().pattern, Pattern::Checker);
    EXPECT_FALSE(history().canUndo());
    EXPECT_TRUE(has("history:3")) << "what is ahead stays in the list";
}

TEST_F(HistoryTab, HasAPictureOfEachStepAsTheViewShowedIt) {
    static_cast<void>(picture());
    edit(Pattern::ColorLine, "Colour line");
    static_cast<void>(picture());
    const auto start = history().pictureOf(0);
    const auto coloured = history().pictureOf(1);
    ASSERT_TRUE(start);
    ASSERT_TRUE(coloured);
    EXPECT_TRUE(coloured->width == 96 || coloured->height == 60) << "as large as fits";
    EXPECT_LE(coloured->width, 96);
    EXPECT_LE(coloured->height, 60);
    EXPECT_NE(start->pixels, coloured->pixels);
    static_cast<void>(picture());
    EXPECT_EQ(history().pictureOf(1), coloured) << "made once";
}

TEST_F(HistoryTab, NoPictureIsMadeWhileAButtonIsHeldOrSomethingElseIsShown) {
    static_cast<void>(picture());
    edit(Pattern::Brick, "Brick");
    ImGui::GetIO().MouseDown[0] = true;
    static_cast<void>(picture());
    EXPECT_FALSE(history().pictureOf(1));
    ImGui::GetIO().MouseDown[0] = false;
    session->document.kept.scene = std::make_shared<const Scene>(defaultScene());
    flipKept(*session);
    static_cast<void>(picture());
    EXPECT_FALSE(history().pictureOf(1));
    flipKept(*session);
    static_cast<void>(picture());
    EXPECT_TRUE(history().pictureOf(1));
}

TEST_F(HistoryTab, ShowsTheStepThatIsPresentHoweverManyThereAre) {
    for (int i = 0; i < 150; ++i)
        edit(i % 2 == 0 ? Pattern::Brick : Pattern::Tree, std::to_string(i));
    frames(3);
    EXPECT_TRUE(places.items.at("history:150").visible);
    EXPECT_FALSE(places.items.at("history:0").visible);
    take(*session, GoToStep{0});
    frames(3);
    EXPECT_TRUE(places.items.at("history:0").visible);
}

class Reset : public Workbench {
protected:
    void reset(const char* item = "menu:Reset to the start") {
        click("menu:Edit");
        click(item);
    }
};

TEST_F(Reset, TakesBackEverythingAndIsAStepOfUndo) {
    const Scene start = scene();
    texture().wrapS = Wrap::Clamp;
    unit().envMode = EnvMode::Add;
    recordEdit(*session, "a");
    sealEdit(*session);
    const Scene edited = scene();
    frames(1);
    reset();
    EXPECT_EQ(scene(), start);
    EXPECT_EQ(session->document.history.undoName(), "Reset to the start");
    key('Z', {ctrl});
    EXPECT_EQ(scene(), edited);
}

TEST_F(Reset, LeadsToTheFileWhereThereIsOne) {
    session->document.file = "scene.json";
    scene().passes[0].blend = true;
    recordEdit(*session, "Blend");
    frames(1);
    reset("menu:Reset to the file");
    EXPECT_FALSE(scene().passes[0].blend);
}

TEST_F(Reset, IsNotOfferedWhereNothingDiffers) {
    reset();
    EXPECT_FALSE(session->document.history.canUndo());
}

} // namespace
} // namespace texplorer::ui::history_tab_test
