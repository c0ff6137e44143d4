#pragma once

// Where everything on a sheet lies, as numbers. All places are counted from the sheet's upper left, in
// pixels.

#include "core/base/result.h"
#include "core/compare/comparison.h"
#include "core/sheet/axis_labels.h"
#include "core/sheet/lettering.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>
#include <vector>

namespace texplorer::sheet {

/// The largest extent of a sheet: what its pictures may have, too.
inline constexpr int maxSheetExtent = 16384;

/// How many pictures are drawn for sheets at once.
inline constexpr std::size_t maxPictures = 4096;

/// What is to be on a sheet.
struct Content {
    std::string title{};    ///< the scene's name
    std::string subtitle{}; ///< which page it is; empty: there is one
    std::string caption{};  ///< below everything: what colours mean; empty: none
    glm::ivec2 cell{1};     ///< the extent of each picture
    AxisLabels down{};      ///< without `across` its pictures fill rows, each above its label
    std::optional<AxisLabels> across{};
    std::string
        widestNote{}; ///< of the notes below pictures, which are known when they are drawn; empty: none
};

/// A line of words.
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
    std::vector<PixelRect> cells{}; ///< of each picture: of a table row by row
    std::vector<PixelRect> notes{}; ///< of each picture; empty: there are none
};

/// How many stand side by side where nothing says it: close to a square, and rather one more than a last row
/// with gaps.
[[nodiscard]] std::size_t columnsFor(std::size_t count);

/// The same distance from all sides of the sheet; every label has the room of its picture, in up to two
/// lines. Errors: TooLarge for a sheet of more than maxSheetExtent.
[[nodiscard]] Result<Layout> layoutOf(const Content& content, const Lettering& lettering);

} // namespace texplorer::sheet
