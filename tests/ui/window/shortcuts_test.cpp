#include "app/ui/widgets/keys.h"
#include "app/ui/window/shortcuts.h"
#include "tests/ui/workbench.h"

#include <set>
#include <tuple>

namespace texplorer::shortcuts_test {
namespace {

using namespace ui;
using test::ctrl;
using test::shift;
using test::Workbench;

TEST(Shortcuts, HaveEachAKeyOfTheirOwnAndAName) {
    std::set<std::tuple<int, bool, bool>> keys;
    std::set<std::string_view> names;
    for (const Shortcut& row : shortcuts()) {
        EXPECT_TRUE(keys.insert({row.key, row.control, row.shift}).second) << labelOf(row);
        EXPECT_TRUE(row.name.empty() || names.insert(row.name).second) << row.name;
        EXPECT_NE(row.act, nullptr) << row.name;
        EXPECT_STRNE(row.effect, "") << row.name;
        EXPECT_LT(row.key, 512) << row.name;
    }
    EXPECT_FALSE(shortcuts().front().name.empty());
}

TEST_F(Workbench, CallsShortcutsAsOnTheKeyboard) {
    EXPECT_EQ(keysOf(*session, "undo"), "Ctrl+Z");
    EXPECT_EQ(keysOf(*session, "redo"), "Ctrl+Shift+Z");
    EXPECT_EQ(keysOf(*session, "play"), "Space");
    EXPECT_EQ(keysOf(*session, "larger text"), "Ctrl++");
    EXPECT_EQ(keysOf(*session, "smaller text"), "Ctrl+−");
    for (const Shortcut& row : shortcuts())
        EXPECT_TRUE(row.key != ui::key::keypadPlus || labelOf(row) == "Ctrl++");
    EXPECT_EQ(keysOf(*session, "full screen"), "F11");
    EXPECT_EQ(keysOf(*session, "view picture"), "Shift+F12");
}

TEST_F(Workbench, TabShowsTheViewAlone) {
    const int before = layout.view.width;
    key(ui::key::tab);
    EXPECT_EQ(maximisedOf(session->settings.workspace), Maximised::View);
    EXPECT_GT(layout.view.width, before);
    EXPECT_FALSE(has("textures[0].minFilter"));
    key(ui::key::tab);
    EXPECT_EQ(maximisedOf(session->settings.workspace), Maximised::None);
    EXPECT_EQ(layout.view.width, before);
}

// Dear ImGui closes a menu before the panels are drawn: the key that closed it is no shortcut as well.
TEST_F(Workbench, EscapeThatClosesAMenuLetsGoOfNothingElse) {
    session->look.explaining.pixel = {3, 3};
    frames(2);
    click("menu:Help");
    frames(2);
    ASSERT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    key(ui::key::escape);
    EXPECT_FALSE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel));
    EXPECT_TRUE(session->look.explaining.pixel);
    key(ui::key::escape);
    EXPECT_FALSE(session->look.explaining.pixel);
}

TEST_F(Workbench, TabIsATextFieldsWhileItHasTheKeyboard) {
    key('F', {ctrl}); // the search among the parameters
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
    key(ui::key::tab);
    EXPECT_EQ(maximisedOf(session->settings.workspace), Maximised::None);
}

TEST_F(Workbench, KeysSwitchWhatTheySayWithTheirModifiers) {
    for (const bool on : {true, false}) {
        key(ui::key::f11);
        EXPECT_EQ(session->window.fillsScreen, on);
    }
    key(ui::key::f12);
    EXPECT_EQ(session->window.wantedCapture, Capture::Window);
    key(ui::key::f12, {shift});
    EXPECT_EQ(session->window.wantedCapture, Capture::View);
    key('M', {shift});
    EXPECT_FALSE(session->view.magnifies);
    key('M');
    EXPECT_TRUE(session->view.magnifies);
}

TEST_F(Workbench, F1ListsTheKeys) {
    key(ui::key::f1);
    EXPECT_EQ(session->asking.dialog, Dialog::Help);
    key(ui::key::f11); // a dialog has its own keys
    EXPECT_FALSE(session->window.fillsScreen);
    key(ui::key::space);
    EXPECT_TRUE(session->look.playback.playing);
    click("help:close");
    EXPECT_FALSE(has("help:close"));
    key(ui::key::f1);
    key(ui::key::escape);
    EXPECT_EQ(session->asking.dialog, Dialog::None);
}

} // namespace
} // namespace texplorer::shortcuts_test
