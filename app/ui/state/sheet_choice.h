#pragma once

#include "texplorer/sheet/axis_labels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

/// The rows or the columns of the sheet of variations.
struct SheetAxis {
    std::string path;
    std::string values = "*"; ///< in the format of sweepAxis

    bool operator==(const SheetAxis&) const = default;
};

/// Rows and columns.
using SheetAxes = std::array<SheetAxis, 2>;

/// The content of the sheet and the options of its file.
struct SheetChoice {
    std::size_t pair = 0;         ///< index into sheetPairs
    std::optional<SheetAxes> own; ///< chosen by the user instead of the pair
    bool swapped = false;         ///< exchanges the pair's rows and columns

    int width = 320; ///< of each picture in the file, in pixels
    int height = 200;
    sheet::LabelKind labels = sheet::LabelKind::Names; ///< in the file
};

} // namespace texplorer::ui
