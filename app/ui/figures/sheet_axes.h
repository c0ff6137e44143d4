#pragma once

#include "app/ui/model/session.h"
#include "core/scene/params/sweep_axis.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// What goes down the sheet, or across it.
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

struct SheetState {
    std::size_t pair = 0;
    std::optional<SheetAxes> own; ///< the user's, in the place of the pair's
    bool swapped = false;         ///< the pair's rows and columns

    std::array<std::string, 2> typed; ///< into the fields of values
    SheetAxes typedOf;                ///< what the fields showed before
    std::string search;               ///< for another parameter
    /// A parameter that may be chosen.
    struct Offer {
        std::string path;
        std::string label;
    };
    std::vector<Offer> offers; ///< those that were found
    bool isOffered = false;    ///< `offers` are those of `search`
};

/// What the sheet shows now.
[[nodiscard]] SheetAxes axesOf(const Session& session, const SheetState& state);

/// The choice of both parameters and their values; and, where there is room for it, a sentence of one line.
void drawSheetAxes(Session& session, SheetState& state, const SheetAxes& shown,
                   const std::function<void()>& sentence);

} // namespace texplorer::ui
