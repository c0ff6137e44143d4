#include "app/ui/widgets/keys.h"
#include "app/ui/window/window_parts.h"

#include <imgui_internal.h> // the last used window

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer::ui {
namespace {

struct ArrowRow {
    int key;
    int x, y; ///< of the picture, whose origin is at the lower left
};
constexpr std::array arrowRows{
    ArrowRow{key::left, -1, 0},
    ArrowRow{key::right, 1, 0},
    ArrowRow{key::up, 0, 1},
    ArrowRow{key::down, 0, -1},
};
constexpr int shiftedStep = 10;

bool ownsArrows(const Session& session, const Layout& layout) {
    const Dock dock = dockOf(session.settings.workspace, Tab::Explain);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (layout.view.contains(mouse.x, mouse.y) || layout.of(dock).contains(mouse.x, mouse.y))
        return true;
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.HoveredWindow || !context.NavWindow)
        return false;
    const std::string_view used = context.NavWindow->RootWindow->Name;
    return used == "View" || used == rowOf(dock).window;
}

} // namespace

void movePixelWithKeys(const Session& session, const Layout& layout, view::Size picture) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool walks = (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0; // arrows move the focus
    if (walks || !session.look.explaining.pixel || !session.look.explaining.isOpen ||
        session.asking.dialog != Dialog::None || session.out.keyTaken || io.WantTextInput || io.KeyCtrl ||
        ImGui::IsAnyItemActive() || !ownsArrows(session, layout) ||
        ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        return;
    const int step = io.KeyShift ? shiftedStep : 1;
    for (const ArrowRow& row : arrowRows) {
        if (!isKeyPressed(row.key))
            continue;
        act(session, [&row, step, picture](Session& changed) {
            std::optional<reference::PixelPlace>& pixel = changed.look.explaining.pixel;
            if (!pixel)
                return;
            pixel->x = std::clamp(pixel->x + row.x * step, 0, std::max(0, picture.width - 1));
            pixel->y = std::clamp(pixel->y + row.y * step, 0, std::max(0, picture.height - 1));
        });
    }
}

} // namespace texplorer::ui
