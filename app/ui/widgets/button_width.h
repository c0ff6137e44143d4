#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// Of a button with this label, in pixels: what a row that doesn't fit has to know before it is drawn.
[[nodiscard]] inline float buttonWidth(const char* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace texplorer::ui
