#pragma once

#include "app/ui/model/session.h"

#include <imgui.h>

#include <string_view>

namespace texplorer::ui {

/// Links the last widget to a parameter: while the pointer is on it, every panel highlights the parameter
/// from the next frame on; while the pointer is on another widget of the parameter, this one is highlighted.
void linkHover(const Session& session, std::string_view path);

/// Draws a frame around the last widget, `margin` pixels apart from it.
void frameItem(float margin, ImU32 ink, float rounding, float width = 1);

} // namespace texplorer::ui
