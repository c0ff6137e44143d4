#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// Continues the line of the last widget if `width` fits after `gap`, else starts the next line. Returns true
/// if it fits.
inline bool sameLineFor(float width, float gap) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    const bool hasRoom = ImGui::GetItemRectMax().x + gap + width <= right;
    if (hasRoom)
        ImGui::SameLine(0, gap);
    return hasRoom;
}

} // namespace texplorer::ui
