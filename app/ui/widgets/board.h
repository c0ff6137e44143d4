#pragma once

#include <imgui.h>

namespace texplorer::ui {

/// A board behind what is transparent, of squares this large.
void drawBoard(ImDrawList& draw, ImVec2 low, ImVec2 high, float cell);

} // namespace texplorer::ui
