#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace texplorer::ui {

/// A level in the strip, in texels.
struct StripLevel {
    int number = 0;
    float width = 1;
    float height = 1;
    float label = 0; ///< width of the text below it, in pixels
};

/// Levels in a row, from left to right. Positions along the strip are in pixels from its left end; positions
/// among the levels are level numbers: 1.5 is half-way between levels 1 and 2.
struct LevelStrip {
    struct Cell {
        int number = 0;
        float left = 0;
        float width = 0;      ///< including its label
        ImVec2 picture{1, 1}; ///< size; centred in the cell

        [[nodiscard]] float middle() const { return left + width / 2; }
    };
    std::vector<Cell> cells;
    float texel = 1; ///< pixels per texel; not if all levels have one size
    ImVec2 extent{0, 0};

    /// Linear between the middles of the cells; at most half a cell beyond the outer ones.
    [[nodiscard]] float placeOf(float level) const;
    /// The inverse of placeOf.
    [[nodiscard]] float levelAt(float place) const;
};

/// Computes the layout. True sizes: the first level is as large as possible with all others next to it, each
/// at least one pixel. `equal`: every level is as large as the square that fits for their number. `zoom`, 1
/// or more, enlarges the pictures. Without levels, or for a room without extent, the result is empty.
[[nodiscard]] LevelStrip layOutLevels(std::span<const StripLevel> levels, ImVec2 room, float gap, bool equal,
                                      float zoom);

} // namespace texplorer::ui
