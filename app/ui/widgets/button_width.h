#pragma once

#include "app/ui/language/translate.h"

#include <imgui.h>

namespace texplorer::ui {

/// The width of a button with these words, in pixels: to check before drawing whether a row fits.
[[nodiscard]] inline float buttonWidth(const char* words) {
    return ImGui::CalcTextSize(tr(words)).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// The width for the text in a list with an arrow.
[[nodiscard]] inline float listRoom(float width) {
    return width - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace texplorer::ui
