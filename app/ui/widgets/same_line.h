#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// Goes on in the line of the last widget where that has room for `width` after `gap`, else in the next one.
/// True where it has.
inline bool sameLineFor(float width, float gap) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const bool hasRoom = ImGui::GetItemRectMax().x + gap + width <= right;
    if (hasRoom)
        ImGui::SameLine(0, gap);
    return hasRoom;
}

} // namespace texplorer::ui
