#pragma once

#include <glm/vec4.hpp>
#include <imgui.h>

namespace texplorer::ui {

/// Draws a board behind transparent parts, with squares of this size.
void drawBoard(ImDrawList& draw, ImVec2 low, ImVec2 high, float cell);

/// A rectangle of a colour, over two by two squares of that board.
void drawCheckered(ImDrawList& draw, ImVec2 low, ImVec2 high, glm::vec4 color);

} // namespace texplorer::ui
