#include "app/ui/files/scene_saving.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/window/text_size.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/storage/scene_link.h"

namespace texplorer::menu_bar_test {
namespace {

using namespace ui;
using test::ctrl;
using test::shift;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class MenuBar : public test::Workbench {
protected:
    [[nodiscard]] int& percent() { return session->settings.textPercent; }
};

TEST_F(MenuBar, TextGrowsAndShrinksByKeys) {
    const float before = ImGui::GetFontSize();
    for (int i = 0; i < 3; ++i)
        key('=', {ctrl});
    EXPECT_EQ(percent(), 150);
    EXPECT_FLOAT_EQ(ImGui::GetFontSize(), std::round(before * 1.5F));
    EXPECT_FLOAT_EQ(layout.scale, 1.5F);
    key('-', {ctrl});
    EXPECT_EQ(percent(), 125);
    key(ui::key::keypadPlus, {ctrl});
    key('=', {ctrl, shift}); // where + needs Shift
    EXPECT_EQ(percent(), 175);
    key('0', {ctrl});
    EXPECT_EQ(percent(), 100);
    EXPECT_FLOAT_EQ(ImGui::GetFontSize(), before);
}

TEST_F(MenuBar, TextHasALargestAndASmallestSize) {
    for (int i = 0; i < 20; ++i)
        changeTextSize(*session, 1);
    EXPECT_EQ(percent(), Settings::maxText);
    for (int i = 0; i < 20; ++i)
        changeTextSize(*session, -1);
    EXPECT_EQ(percent(), Settings::minText);
    percent() = 130; // between two
    changeTextSize(*session, 1);
    EXPECT_EQ(percent(), 150);
    percent() = 130;
    changeTextSize(*session, -1);
    EXPECT_EQ(percent(), 125);
    frames(2);
    expectSoundFrame();
}

TEST_F(MenuBar, CtrlAndTheWheelResizeWhereNothingElseDoes) {
    const auto turn = [&](ImVec2 where, float notches) {
        setHeld(ctrl, true);
        wheel(where, notches);
        setHeld(ctrl, false);
        frames(1);
    };
    turn(place("parameters"), 1);
    EXPECT_EQ(percent(), 110);
    turn(place("parameters"), -2);
    EXPECT_EQ(percent(), 90);
    turn(place("view"), 1);
    EXPECT_EQ(percent(), 90) << "there it enlarges pixels";
    EXPECT_EQ(session->view.zoom.factor, 2);
    turn({static_cast<float>(layout.texture.x + 60), static_cast<float>(layout.texture.bottom() - 60)}, 1);
    EXPECT_EQ(percent(), 90);
    wheel(place("parameters"), -1);
    EXPECT_EQ(percent(), 90) << "without Ctrl it scrolls";
    for (int i = 0; i < 3; ++i) // a touchpad
        turn(place("status"), 0.4F);
    EXPECT_EQ(percent(), 90) << "Ctrl was let go in between";
}

TEST_F(MenuBar, EverySizeOfTextFillsTheWindow) {
    for (const int size : {Settings::minText, Settings::maxText}) {
        percent() = size;
        frames(3);
        expectSoundFrame();
    }
}

TEST_F(MenuBar, AThemeIsChosenInTheMenu) {
    click("menu:View");
    click("menu:Theme");
    click("menu:Light colours");
    EXPECT_EQ(session->settings.theme, Theme::Light);
    frames(1);
    EXPECT_EQ(static_cast<ImU32>(color::text), paletteOf(Theme::Light).text);
    EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(ImGui::GetStyle().Colors[ImGuiCol_WindowBg]),
              paletteOf(Theme::Light).panel);
}

TEST_F(MenuBar, TextSizesAreInTheMenu) {
    click("menu:View");
    click("menu:Text size");
    click("menu:200 %");
    EXPECT_EQ(percent(), 200);
}

TEST_F(MenuBar, HelpStandsBelowOrBesideThePointer) {
    moveTo(place("play"));
    frames(2);
    EXPECT_TRUE(has("hint"));
    session->settings.helpBelow = false;
    frames(2);
    EXPECT_FALSE(has("hint"));
}

/// A link in the clipboard, which Dear ImGui keeps if the system has none.
TEST_F(MenuBar, ALinkLeadsBackToTheScene) {
    texture().wrapS = Wrap::ClampToBorder;
    recordEdit(*session, "Wrap s");
    click("menu:File");
    click("menu:Copy link to this scene");
    const std::string link = ImGui::GetClipboardText();
    EXPECT_THAT(link, StartsWith("texplorer:1:"));
    EXPECT_TRUE(session->look.notice.isGood);
    const Scene copied = scene();
    start(defaultScene());
    ASSERT_NE(scene(), copied);
    ImGui::SetClipboardText(link.c_str());
    key('V', {ctrl});
    frames(2);
    EXPECT_EQ(texture().wrapS, Wrap::ClampToBorder);
    EXPECT_FALSE(isDirty(session->document));
}

TEST_F(MenuBar, UnsavedChangesAreAskedAboutBeforeALinkIsOpened) {
    const std::string link = writeSceneLink(defaultScene()).value();
    texture().wrapS = Wrap::ClampToBorder;
    recordEdit(*session, "Wrap s");
    ImGui::SetClipboardText(link.c_str());
    key('V', {ctrl});
    frames(3);
    EXPECT_EQ(session->asking.dialog, Dialog::Discard);
    EXPECT_EQ(texture().wrapS, Wrap::ClampToBorder);
    click("discard:drop");
    frames(3);
    EXPECT_EQ(texture().wrapS, defaultScene().textures.front().wrapS);
}

TEST_F(MenuBar, WhatIsNoLinkIsSaid) {
    for (const auto& [text, said] :
         {std::pair("some words", "no link"), std::pair("texplorer:1:%", "damaged"),
          std::pair("texplorer:2:AAAA", "later version")}) {
        ImGui::SetClipboardText(text);
        session->look.notice = {};
        key('V', {ctrl});
        EXPECT_THAT(session->look.notice.text, HasSubstr(said));
        EXPECT_FALSE(session->look.notice.isGood);
    }
}

TEST_F(MenuBar, RecentFilesOpenAgain) {
    const test::TempDir folder;
    ASSERT_TRUE(saveScene(*session, folder / "mine.json"));
    EXPECT_THAT(session->settings.recentFiles, ElementsAre(folder / "mine.json"));
    const Settings settings = session->settings;
    start(defaultScene());
    session->settings = settings;
    click("menu:File");
    click("menu:Open recent");
    click("menu:mine.json");
    frames(2);
    EXPECT_EQ(session->document.file, folder / "mine.json");
    click("menu:File");
    click("menu:Open recent");
    click("menu:Forget these files");
    EXPECT_TRUE(session->settings.recentFiles.empty());
}

} // namespace
} // namespace texplorer::menu_bar_test
