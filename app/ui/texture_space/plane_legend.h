#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texture_space_state.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// What names the things that are shown, at the upper edge of the plane.
struct PlaneLegend {
    /// A line of it, with what a stroke looks like where it names one.
    struct Line {
        std::string text;
        enum class Stroke : std::uint8_t { None, Faint, Strong } stroke = Stroke::None;
        std::string shown{}; ///< what of the text has room, in the window's language
    };
    std::vector<Line> lines;
    bool inOneRow = false; ///< beside each other, not one above the other
    std::string extents;   ///< of the texture: "64 × 1", "6 faces of 32 × 32", "no texture"; empty: unknown
};

/// As much as has room beside each other in the plane.
[[nodiscard]] PlaneLegend legendOf(const Session& session, const TextureSpaceState& state, float room);

/// Where it is drawn.
[[nodiscard]] Box boxOf(const PlaneLegend& legend, ImVec2 corner);

void drawPlaneLegend(ImDrawList& draw, const PlaneLegend& legend, const Box& box);

/// What is going on while vertices follow the mouse, at the lower edge, or why they don't, at the mouse.
void drawMoveHint(ImDrawList& draw, const Canvas& canvas, const VertexMove& move);

} // namespace texplorer::ui
