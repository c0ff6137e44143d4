#pragma once

#include "app/ui/state/sheet_choice.h"
#include "texplorer/scene/params/sweep_axis.h"
#include "texplorer/sheet/axis_labels.h"

#include <array>
#include <cstddef>
#include <string>

namespace texplorer::ui {

struct Session; // see session.h

/// A pair of related parameters of the selected objects.
struct SheetPair {
    const char* name; ///< its name in tests
    const char* label;
    const char* help;
    SheetAxes (*axes)(const Session& session);
};
[[nodiscard]] const std::array<SheetPair, 4>& sheetPairs();

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
