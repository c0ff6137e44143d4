#pragma once

#include "core/scene/params/sweep_axis.h"
#include "core/sheet/axis_labels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// What goes down the sheet of variations, or across it.
struct SheetAxis {
    std::string path;
    std::string values = "*"; ///< as sweepAxis reads them

    bool operator==(const SheetAxis&) const = default;
};

/// Rows and columns.
using SheetAxes = std::array<SheetAxis, 2>;

/// Two parameters that belong together, of what is selected.
struct SheetPair {
    const char* name; ///< what tests call it
    const char* label;
    const char* help;
    SheetAxes (*axes)(const Session& session);
};
[[nodiscard]] const std::array<SheetPair, 4>& sheetPairs();

/// What the sheet is made of, and how it is written.
struct SheetChoice {
    std::size_t pair = 0;         ///< of sheetPairs
    std::optional<SheetAxes> own; ///< the user's, in the place of the pair's
    bool swapped = false;         ///< the pair's rows and columns

    int width = 320; ///< of each picture in the file, in pixels
    int height = 200;
    sheet::LabelKind labels = sheet::LabelKind::Names; ///< in the file
};

/// What the sheet shows now.
[[nodiscard]] SheetAxes axesOf(const Session& session);

/// The same with every value. Errors: there is no such parameter or value, both are the same one.
[[nodiscard]] Result<std::array<SweepAxis, 2>> sweptAxes(const Session& session);

/// A parameter goes down the sheet (`side` 0) or across it (1), with all its values, and the sheet comes to
/// the front. Where it was the other side's, that one gets what was here.
void varyOnSheet(Session& session, std::string path, std::size_t side);

/// The sheet comes to the front.
void showSheet(Session& session);

} // namespace texplorer::ui
