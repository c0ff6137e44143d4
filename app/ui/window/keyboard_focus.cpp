#include "app/ui/widgets/keys.h"
#include "app/ui/window/window_parts.h"

#include <imgui_internal.h> // windows and their focus

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float minPanelWidth = 30; // seams are narrower

/// The keys for moving the focus, which are not shortcuts meanwhile.
constexpr std::array walkingKeys{key::space, key::enter, key::tab,      key::left,   key::right, key::up,
                                 key::down,  key::home,  key::pageDown, key::pageUp, key::end};

/// The visible panels in reading order.
std::vector<ImGuiWindow*> panelsInOrder() {
    constexpr ImGuiWindowFlags none = ImGuiWindowFlags_ChildWindow | ImGuiWindowFlags_Popup |
                                      ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoNavFocus;
    std::vector<ImGuiWindow*> panels;
    for (ImGuiWindow* each : ImGui::GetCurrentContext()->Windows) {
        const bool isPanel = each->WasActive && !each->Hidden && (each->Flags & none) == 0;
        if (isPanel && each->Size.x >= minPanelWidth && each->Size.y >= ImGui::GetFontSize())
            panels.push_back(each);
    }
    std::ranges::sort(panels, {},
                      [](const ImGuiWindow* each) { return std::tuple(each->Pos.y, each->Pos.x, each->ID); });
    return panels;
}

void focusNextPanel(int steps) {
    const std::vector<ImGuiWindow*> panels = panelsInOrder();
    if (panels.empty())
        return;
    ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiWindow* now = context.NavWindow ? context.NavWindow->RootWindow : nullptr;
    const auto found = std::ranges::find(panels, now);
    const auto count = static_cast<int>(panels.size());
    const int from = found == panels.end() ? (steps > 0 ? -1 : 0) : static_cast<int>(found - panels.begin());
    ImGuiWindow* next = panels[static_cast<std::size_t>((from + steps + count) % count)];
    ImGui::FocusWindow(next);
    const bool hasBody = (next->DC.NavLayersActiveMask & (1 << ImGuiNavLayer_Main)) != 0;
    context.NavLayer = hasBody ? ImGuiNavLayer_Main : ImGuiNavLayer_Menu;
    ImGui::NavInitWindow(next, true);
    context.NavDisableHighlight = false;
}

} // namespace

void moveKeyboardFocus(const Session& session, KeyboardFocus& focus) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool isFree = session.asking.dialog == Dialog::None && !io.WantTextInput && !session.out.keyTaken;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || session.asking.dialog != Dialog::None)
        focus.walks = false;
    if (isFree && isKeyPressed(key::f6, false)) {
        focusNextPanel(io.KeyShift ? -1 : 1);
        focus.walks = true;
    } else if (focus.walks && isFree && isKeyPressed(key::escape, false)) {
        focus.walks = false;
        session.out.keyTaken = true;
    }
    if (focus.walks && std::ranges::any_of(walkingKeys, [](int each) { return isKeyPressed(each); }))
        session.out.keyTaken = true;
}

} // namespace texplorer::ui
