#include "app/ui/window/text_size.h"

#include <imgui.h>

#include <algorithm>

namespace texplorer::ui {

void changeTextSize(Session& session, int steps) {
    int& percent = session.settings.textPercent;
    // Between two sizes, the next one in that direction.
    const auto* above = std::ranges::upper_bound(textSizes, percent);
    const auto* from = std::ranges::lower_bound(textSizes, percent);
    const auto index = steps > 0 ? above - textSizes.begin() + steps - 1 : from - textSizes.begin() + steps;
    percent = textSizes[static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(textSizes.size()) - 1))];
}

void resizeTextByWheel(const Session& session, float& turned, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    const Workspace& workspace = session.settings.workspace;
    const auto isOver = [&](const Rect& rect) { return rect.contains(io.MousePos.x, io.MousePos.y); };
    const bool zooms = isOver(layout.canvas) || isOver(layout.texture) ||
                       (isShown(workspace, Tab::Levels) && isOver(layout.of(dockOf(workspace, Tab::Levels))));
    if (!io.KeyCtrl || session.asking.dialog != Dialog::None || zooms) {
        turned = 0;
        return;
    }
    turned += io.MouseWheel; // the notches of a touchpad are small
    const int steps = static_cast<int>(turned);
    turned -= static_cast<float>(steps);
    if (steps != 0)
        act(session, [steps](Session& s) { changeTextSize(s, steps); });
}

} // namespace texplorer::ui
