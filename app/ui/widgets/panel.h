#pragma once

#include "app/ui/state/layout.h"

#include <imgui.h>

namespace texplorer::ui {

[[nodiscard]] inline ImVec2 lowOf(const Rect& rect) {
    return {static_cast<float>(rect.x), static_cast<float>(rect.y)};
}
[[nodiscard]] inline ImVec2 extentOf(const Rect& rect) {
    return {static_cast<float>(rect.width), static_cast<float>(rect.height)};
}
[[nodiscard]] inline ImVec2 highOf(const Rect& rect) {
    return {static_cast<float>(rect.right()), static_cast<float>(rect.bottom())};
}

/// Begins a window that fills a rectangle and cannot be moved. End it with ImGui::End(). It draws no
/// background: a software renderer takes as long for blending it as for all of its content.
void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

/// The same with the background of a menu bar, for the strips around panels.
void beginBar(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

/// The colour to which the host clears the window before it draws panels.
[[nodiscard]] ImVec4 panelGround();

} // namespace texplorer::ui
