// The presets in the menu bar.

#include "tests/ui/workbench.h"
#include "texplorer/preset/preset.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>

namespace texplorer::ui::presets_menu_test {
namespace {

using namespace test;
using testing::HasSubstr;

class PresetsMenu : public Workbench {
protected:
    void choosePreset(std::string_view name) {
        click("menu:Presets");
        click("preset:" + std::string(name));
    }
};

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
} // namespace texplorer::ui::presets_menu_test
