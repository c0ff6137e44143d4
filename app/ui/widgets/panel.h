#pragma once

#include "app/ui/model/layout.h"

#include <imgui.h>

namespace texplorer::ui {

/// A window that fills a rectangle and can't be moved. To be closed with ImGui::End(). It draws no ground of
/// its own: a software renderer spends as long on blending a window's as on all that stands on it.
void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

/// The same with the ground of a menu bar, for the strips around panels.
void beginBar(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

/// What the host clears the window to before it draws panels.
[[nodiscard]] ImVec4 panelGround();

} // namespace texplorer::ui
