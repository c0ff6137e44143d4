#pragma once

// The layout of a sheet in numbers. All positions are in pixels from the sheet's upper left.

#include "texplorer/base/result.h"
#include "texplorer/compare/comparison.h"
#include "texplorer/sheet/axis_labels.h"
#include "texplorer/sheet/lettering.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace texplorer::sheet {

/// The largest extent of a sheet, and of its pictures.
inline constexpr int maxSheetExtent = 16384;

/// The maximum number of pictures of a run.
inline constexpr std::size_t maxPictures = 4096;

/// The content of a sheet.
struct Content {
    std::string title{};    ///< the scene's name
    std::string subtitle{}; ///< which page it is; empty: the only one
    std::string caption{};  ///< a text at the bottom: the meaning of colours; empty: none
    glm::ivec2 cell{1};     ///< the extent of each picture
    AxisLabels down{};      ///< without `across`, the pictures fill rows, each with its label below
    std::optional<AxisLabels> across{};
    std::string
        widestNote{}; ///< the widest note below pictures, as notes are known only after drawing; empty: none
};

/// A line of text.
struct Line {
    int left = 0;
    int top = 0;
    TextRole role = TextRole::Label;
    std::string text{};

    bool operator==(const Line&) const = default;
};

struct Layout {
    glm::ivec2 size{0};
    std::vector<Line> lines{};
    std::vector<PixelRect> cells{}; ///< one per picture: of a table row by row
    std::vector<PixelRect> notes{}; ///< one per picture; empty: none
};

/// The number of columns by default: nearly a square, with one more column if that avoids gaps in the last
/// row.
[[nodiscard]] std::size_t columnsFor(std::size_t count);

/// Computes the layout: the same margin on all sides; every label has the width of its picture, in up to two
/// lines. Errors: TooLarge for a sheet above maxSheetExtent.
[[nodiscard]] Result<Layout> layoutOf(const Content& content, const Lettering& lettering);

} // namespace texplorer::sheet
