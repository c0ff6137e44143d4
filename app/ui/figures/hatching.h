#pragma once

#include <imgui.h>

#include <span>

namespace texplorer::ui {

/// Draws parallel lines from lower left to upper right within a convex polygon, `gap` pixels apart; lines of
/// adjacent shapes are aligned.
void hatch(ImDrawList& draw, std::span<const ImVec2> polygon, float gap, ImU32 tint, float width);

} // namespace texplorer::ui
