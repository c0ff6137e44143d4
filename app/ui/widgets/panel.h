#pragma once

#include "app/ui/model/layout.h"

#include <imgui.h>

namespace texplorer::ui {

/// A window that fills a rectangle and can't be moved. To be closed with ImGui::End().
void beginPanel(const char* name, const Rect& rect, ImGuiWindowFlags flags = 0);

} // namespace texplorer::ui
