#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

#include <imgui_internal.h>

#include <set>
#include <string>

namespace texplorer::keyboard_focus_test {
namespace {

using namespace ui;
using test::shift;

class KeyboardFocusTest : public test::Workbench {
protected:
    [[nodiscard]] static std::string panel() {
        const ImGuiWindow* now = ImGui::GetCurrentContext()->NavWindow;
        return now ? now->RootWindow->Name : "";
    }
};

TEST_F(KeyboardFocusTest, F6LeadsThroughAllPanelsAndBack) {
    std::vector<std::string> visited;
    for (int i = 0; i < 12; ++i) {
        key(ui::key::f6);
        visited.push_back(panel());
    }
    EXPECT_GE(std::set<std::string>(visited.begin(), visited.end()).size(), 5U);
    const std::string last = panel();
    key(ui::key::f6);
    key(ui::key::f6, {shift});
    EXPECT_EQ(panel(), last);
}

TEST_F(KeyboardFocusTest, SpaceWorksAControlUntilEscape) {
    const bool playing = session->look.playback.playing;
    key(ui::key::f6);
    EXPECT_TRUE(states.keyboard.walks);
    EXPECT_NE(ImGui::GetCurrentContext()->NavId, 0U);
    key(ui::key::down);
    key(ui::key::escape);
    EXPECT_FALSE(states.keyboard.walks);
    EXPECT_EQ(session->look.playback.playing, playing);
    key(ui::key::space);
    EXPECT_NE(session->look.playback.playing, playing);
}

TEST_F(KeyboardFocusTest, AMenuOpensByKeysAlone) {
    for (int i = 0; i < 20 && panel() != "Menu"; ++i)
        key(ui::key::f6);
    ASSERT_EQ(panel(), "Menu");
    key(ui::key::space);
    frames(2);
    EXPECT_TRUE(has("menu:New") || has("menu:Quit"));
}

} // namespace
} // namespace texplorer::keyboard_focus_test
