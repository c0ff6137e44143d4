#pragma once

#include <imgui.h>

#include <span>

namespace texplorer::ui {

/// Parallel lines from lower left to upper right within a convex polygon, `gap` pixels apart; those of shapes
/// side by side meet.
void hatch(ImDrawList& draw, std::span<const ImVec2> polygon, float gap, ImU32 tint, float width);

} // namespace texplorer::ui
