#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace texplorer::ui {

/// A level that stands in the strip, in texels.
struct StripLevel {
    int number = 0;
    float width = 1;
    float height = 1;
    float label = 0; ///< width of what is written below it, in pixels
};

/// Levels beside each other, from left to right. Places along the strip are in pixels from its left end,
/// places among the levels are numbers of levels: 1.5 is half-way between levels 1 and 2.
struct LevelStrip {
    struct Cell {
        int number = 0;
        float left = 0;
        float width = 0;      ///< with its label
        ImVec2 picture{1, 1}; ///< in the middle of the cell

        [[nodiscard]] float middle() const { return left + width / 2; }
    };
    std::vector<Cell> cells;
    float texel = 1; ///< pixels of one; not where all levels have one size
    ImVec2 extent{0, 0};

    /// Linear between the middles of the cells; half a cell beyond the outer ones, and never further.
    [[nodiscard]] float placeOf(float level) const;
    /// The other way round.
    [[nodiscard]] float levelAt(float place) const;
};

/// True sizes: the first level as large as a room allows in which all others stand beside it, none less than
/// a pixel. `equal`: each as large as a square that fits as often as there are levels. `zoom`, 1 or more,
/// makes the pictures so many times larger. No level, or a room without extent: empty.
[[nodiscard]] LevelStrip layOutLevels(std::span<const StripLevel> levels, ImVec2 room, float gap, bool equal,
                                      float zoom);

} // namespace texplorer::ui
