#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texture_space_state.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// Names the things that are shown, at the upper edge of the plane.
struct PlaneLegend {
    /// A line of the legend, with a sample of the stroke that it names.
    struct Line {
        std::string text;
        enum class Stroke : std::uint8_t { None, Faint, Strong } stroke = Stroke::None;
        std::string shown{}; ///< the part of the text that fits, in the window's language
    };
    std::vector<Line> lines;
    bool inOneRow = false; ///< in one row, not one above the other
    std::string extents;   ///< of the texture: "64 × 1", "6 faces of 32 × 32", "no texture"; empty: unknown
};

/// As many entries as fit in one row of the plane.
[[nodiscard]] PlaneLegend legendOf(const Session& session, const TextureSpaceState& state, float room);

/// The rectangle of the legend.
[[nodiscard]] Box boxOf(const PlaneLegend& legend, ImVec2 corner);

void drawPlaneLegend(ImDrawList& draw, const PlaneLegend& legend, const Box& box);

/// Draws the state of a move at the lower edge, or, at the mouse, why vertices do not move.
void drawMoveHint(ImDrawList& draw, const Canvas& canvas, const VertexMove& move);

} // namespace texplorer::ui
