#pragma once

#include "core/scene/params/sweep_axis.h"
#include "core/sheet/axis_labels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// The rows or the columns of the sheet of variations.
struct SheetAxis {
    std::string path;
    std::string values = "*"; ///< in the format of sweepAxis

    bool operator==(const SheetAxis&) const = default;
};

/// Rows and columns.
using SheetAxes = std::array<SheetAxis, 2>;

/// A pair of related parameters of the selected objects.
struct SheetPair {
    const char* name; ///< its name in tests
    const char* label;
    const char* help;
    SheetAxes (*axes)(const Session& session);
};
[[nodiscard]] const std::array<SheetPair, 4>& sheetPairs();

/// The content of the sheet and the options of its file.
struct SheetChoice {
    std::size_t pair = 0;         ///< index into sheetPairs
    std::optional<SheetAxes> own; ///< chosen by the user instead of the pair
    bool swapped = false;         ///< exchanges the pair's rows and columns

    int width = 320; ///< of each picture in the file, in pixels
    int height = 200;
    sheet::LabelKind labels = sheet::LabelKind::Names; ///< in the file
};

/// The axes that the sheet shows.
[[nodiscard]] SheetAxes axesOf(const Session& session);

/// The same with all values. Errors: there is no such parameter or value, or both are the same parameter.
[[nodiscard]] Result<std::array<SweepAxis, 2>> sweptAxes(const Session& session);

/// Puts a parameter with all its values on the rows (`side` 0) or the columns (1) of the sheet, and shows the
/// sheet. If it was on the other side, the two are exchanged.
void varyOnSheet(Session& session, std::string path, std::size_t side);

/// Shows the sheet.
void showSheet(Session& session);

} // namespace texplorer::ui
