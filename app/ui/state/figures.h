#pragma once

#include "texplorer/lesson/lesson.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer::ui {

/// Interactive figures that explain a topic next to the scene, all in one tab.
enum class Figure { Environments, Sheet, Block, Flip, Objects, Emboss, Edge, Upload, Cost };

struct FigureRow {
    Figure figure;
    std::string_view name; ///< for lessons and texshot's --figure
    const char* label;
    const char* help;
};

inline constexpr std::array figureRows{
    FigureRow{Figure::Environments, "environments", N_("Environments"),
              N_("The result of each environment mode with each base format, in symbols and in numbers.")},
    FigureRow{Figure::Sheet, "sheet", N_("Sheet"),
              N_("The scene with every pair of values of two parameters. A click applies them.")},
    FigureRow{Figure::Block, "block", N_("Block"),
              N_("A compressed block of 4 × 4 texels, bit by bit: its end colours, palette and indices.")},
    FigureRow{Figure::Flip, "flip", N_("Block flip"),
              N_("How compressed blocks are flipped without decompressing, for every height.")},
    FigureRow{Figure::Objects, "objects", N_("Texture objects"),
              N_("What glBindTexture switches, and what stays with the unit.")},
    FigureRow{Figure::Emboss, "emboss", N_("Emboss"),
              N_("How two heights, a light and a slope make a bump.")},
    FigureRow{Figure::Edge, "edge", N_("Edge lens"),
              N_("Which texels are mixed across the edges of a texture, for each wrap mode and filter.")},
    FigureRow{Figure::Upload, "upload", N_("Upload"),
              N_("The bytes of the program's memory, and the texels that glTexImage makes of them.")},
    FigureRow{
        Figure::Cost, "cost", N_("Cost"),
        N_("How long this driver takes for what the documents call slow or fast: measured in pairs, with "
           "the spread.")},
};

[[nodiscard]] constexpr const FigureRow& rowOf(Figure figure) {
    return figureRows[static_cast<std::size_t>(figure)];
}
static_assert(std::ranges::all_of(figureRows,
                                  [](const FigureRow& row) { return &rowOf(row.figure) == &row; }));
static_assert(std::ranges::equal(figureRows, lesson::lookFigures, {}, &FigureRow::name));

} // namespace texplorer::ui
