#pragma once

#include <glm/vec4.hpp>
#include <imgui.h>

namespace texplorer::ui {

/// A rectangle of a colour, over two by two squares of the board that stands behind what is transparent.
void drawCheckered(ImDrawList& draw, ImVec2 low, ImVec2 high, glm::vec4 color);

} // namespace texplorer::ui
