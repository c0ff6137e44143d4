#pragma once

#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texture_space_state.h"
#include "texplorer/base/sentence.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// Names the things that are shown, at the upper edge of the plane.
struct PlaneLegend {
    /// A line of the legend, with a sample of the stroke that it names.
    struct Line {
        Sentence text;
        enum class Stroke : std::uint8_t { None, Faint, Strong } stroke = Stroke::None;
        std::string shown{}; ///< the part of the text that fits, in the window's language
        float width = 0;     ///< with the sample
    };
    std::vector<Line> lines;
    bool inOneRow = false; ///< in one row, not one above the other
    Box box{};
    Sentence extents; ///< of the texture: "64 × 1", "6 faces of 32 × 32", "no texture"; empty: unknown
};

/// The entries in one row if it is not wider than `room`, else one above the other.
[[nodiscard]] PlaneLegend legendOf(const Session& session, const TextureSpaceState& state, ImVec2 corner,
                                   float room);

void drawPlaneLegend(ImDrawList& draw, const PlaneLegend& legend);

/// Draws the state of a move at the lower edge, or, at the mouse, why vertices do not move.
void drawMoveHint(ImDrawList& draw, const Canvas& canvas, const VertexMove& move);

} // namespace texplorer::ui
