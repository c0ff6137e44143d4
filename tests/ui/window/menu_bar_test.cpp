#include "app/ui/files/scene_saving.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/palette.h"
#include "app/ui/window/text_size.h"
#include "tests/support/temp_dir.h"
#include "tests/ui/edits.h"
#include "tests/ui/workbench.h"
#include "texplorer/files/file_io.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/storage/scene_link.h"

#include <imgui_internal.h>

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
    void item(std::string_view menu, std::string_view name) {
        click("menu:" + std::string(menu));
        click("menu:" + std::string(name));
    }
    void choosePreset(std::string_view name) {
        click("menu:Presets");
        click("preset:" + std::string(name));
    }
};
using PresetsMenu = MenuBar;
using EditMenu = MenuBar;

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
    item("View", "Theme");
    click("menu:Light colours");
    EXPECT_EQ(session->settings.theme, Theme::Light);
    frames(1);
    EXPECT_EQ(static_cast<ImU32>(color::text), paletteOf(Theme::Light).text);
    EXPECT_EQ(ImGui::ColorConvertFloat4ToU32(ImGui::GetStyle().Colors[ImGuiCol_WindowBg]),
              paletteOf(Theme::Light).panel);
}

TEST_F(MenuBar, TextSizesAreInTheMenu) {
    item("View", "Text size");
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
    item("File", "Copy link to this scene");
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
    item("File", "Open recent");
    click("menu:mine.json");
    frames(2);
    EXPECT_EQ(session->document.file, folder / "mine.json");
    item("File", "Open recent");
    click("menu:Forget these files");
    EXPECT_TRUE(session->settings.recentFiles.empty());
}

TEST_F(EditMenu, NamesWhatItUndoesAndRedoes) {
    choose("textures[0].wrapS", "GL_CLAMP");
    item("Edit", "Undo Wrap s: Clamp (legacy)");
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    item("Edit", "Redo Wrap s: Clamp (legacy)");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
}

TEST_F(EditMenu, ResetsATextureToGlsInitialValuesButKeepsItsImage) {
    texture().pattern = Pattern::Brick;
    texture().wrapS = Wrap::Clamp;
    item("Edit", "Texture parameters");
    EXPECT_EQ(texture().pattern, Pattern::Brick);
    EXPECT_EQ(texture().wrapS, Wrap::Repeat);
    EXPECT_EQ(texture().minFilter, MinFilter::NearestMipmapLinear);
}

TEST_F(EditMenu, ResetsAUnitButKeepsItsBinding) {
    unit().envMode = EnvMode::Add;
    unit().matrix.resize(3);
    item("Edit", "Texture unit");
    EXPECT_EQ(unit(), (Unit{.enabled = true}));
}

TEST_F(EditMenu, ResetsEverythingAndUndoesIt) {
    const Scene before = scene();
    item("Edit", "Everything but models and view");
    EXPECT_EQ(scene().material, Material{});
    EXPECT_EQ(scene().light, Light{});
    EXPECT_EQ(scene().models, before.models);
    EXPECT_EQ(scene().view, before.view);
    key('Z', {ctrl});
    EXPECT_EQ(scene(), before);
}

TEST_F(EditMenu, ViewShowsShapes) {
    item("View", "Show Cube");
    EXPECT_TRUE(scene().models[0].visible);
    EXPECT_FALSE(scene().models[1].visible);
}

TEST_F(EditMenu, ArrowsAndEnterWorkInAnOpenList) {
    scrollTo("textures[0].internalFormat");
    click("textures[0].internalFormat");
    key(ui::key::down);
    key(ui::key::space);
    EXPECT_NE(texture().internalFormat, InternalFormat::Rgba);
    EXPECT_TRUE(session->look.playback.playing) << "Space was the list's";
}

TEST_F(EditMenu, TheListsFollowWhatUndoShows) {
    item("View", "Show Sphere");
    EXPECT_EQ(session->look.selection.model, 1);
    scene().models[0].visible = true;
    scene().models[1].visible = false;
    recordEdit(*session, "Visible");
    EXPECT_EQ(session->look.selection.model, 1) << "hiding a model does not move the selection off it";
    key('Z', {ctrl});
    EXPECT_EQ(session->look.selection.model, 1);
    key('Y', {ctrl});
    EXPECT_EQ(session->look.selection.model, 0);
}

TEST_F(PresetsMenu, OffersEachOfThem) {
    click("menu:Presets");
    for (const Preset& each : presets())
        EXPECT_TRUE(has("preset:" + std::string(each.name))) << each.name;
}

TEST_F(PresetsMenu, IsOneStepOfUndoThatBearsItsName) {
    const Scene before = scene();
    choosePreset("alpha-test");
    EXPECT_TRUE(scene().passes[0].alphaTest);
    EXPECT_EQ(texture().pattern, Pattern::Tree);
    EXPECT_EQ(session->document.history.undoName(), "Alpha test > 0.5");
    EXPECT_THAT(session->look.notice.text, HasSubstr("the far sides show through the holes"));
    key('Z', {ctrl});
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
}

TEST_F(PresetsMenu, IsAboutTheSelectedUnit) {
    session->look.selection.unit = 1;
    choosePreset("sphere-map");
    EXPECT_FALSE(scene().passes[0].units[0].texGenS.enabled);
    EXPECT_TRUE(scene().passes[0].units[1].texGenS.enabled);
}

TEST_F(PresetsMenu, SelectsAUnitThatIsOn) {
    choosePreset("wrong-unit");
    EXPECT_EQ(session->look.selection.unit, 1);
    choosePreset("wrong-unit-cure");
    EXPECT_EQ(session->look.selection.unit, 0);
    EXPECT_TRUE(scene().passes[0].units[0].enabled);
}

TEST_F(PresetsMenu, ShowsWhatItWouldDoWhileThePointerRestsOnIt) {
    const Scene before = scene();
    click("menu:Presets");
    moveTo(place("preset:anisotropy"));
    ASSERT_TRUE(session->look.preview);
    EXPECT_EQ(session->look.preview->scene->textures[0].maxAnisotropy, 16);
    EXPECT_EQ(scene(), before);
    EXPECT_FALSE(session->document.history.canUndo());
    moveTo(place("preset:decal"));
    ASSERT_TRUE(session->look.preview);
    EXPECT_EQ(session->look.preview->scene->passes[0].units[0].envMode, EnvMode::Decal);
    moveTo({600, 700});
    EXPECT_FALSE(session->look.preview);
}

TEST_F(PresetsMenu, ExplainsItselfBesideTheMenuAndThePicture) {
    click("menu:Presets");
    for (const Preset& each : presets()) {
        moveTo(place("preset:" + std::string(each.name)));
        const ImGuiWindow* tip = ImGui::FindWindowByName("##Tooltip_00");
        ASSERT_TRUE(tip && tip->Active) << each.name;
        for (const char* covered : {"View", "##Menu_00"}) {
            const ImGuiWindow* other = ImGui::FindWindowByName(covered);
            ASSERT_TRUE(other && other->Active) << covered;
            EXPECT_FALSE(tip->Rect().Overlaps(other->Rect())) << each.name << " over " << covered;
        }
    }
}

TEST_F(PresetsMenu, LetsWhatMovesPlay) {
    session->look.playback.playing = false;
    choosePreset("decal");
    EXPECT_FALSE(session->look.playback.playing);
    choosePreset("scroll");
    EXPECT_TRUE(session->look.playback.playing);
}

TEST_F(PresetsMenu, SelectsAModelThatOneSees) {
    session->look.selection.vertex = 3;
    choosePreset("shimmer");
    EXPECT_EQ(scene().models[static_cast<std::size_t>(session->look.selection.model)].shape, Shape::Floor);
    EXPECT_FALSE(session->look.selection.vertex);
}

TEST_F(PresetsMenu, SaysWhyThereIsNoRoom) {
    for (Unit& each : scene().passes[0].units)
        each.enabled = true;
    const Scene before = scene();
    choosePreset("detail");
    EXPECT_EQ(scene(), before);
    EXPECT_THAT(session->look.notice.text, HasSubstr("4 units"));
}

} // namespace
} // namespace texplorer::menu_bar_test
