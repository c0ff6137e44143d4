#pragma once

#include "app/ui/language/translate.h"

#include <imgui.h>

namespace texplorer::ui {

/// Of a button with these words on it, in pixels: what a row that doesn't fit has to know before it is drawn.
[[nodiscard]] inline float buttonWidth(const char* words) {
    return ImGui::CalcTextSize(tr(words)).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// What the words of a list with an arrow have of its width.
[[nodiscard]] inline float listRoom(float width) {
    return width - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace texplorer::ui
