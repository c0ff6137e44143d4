#pragma once

#include "app/ui/model/session.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// What the controls remember.
struct SheetState {
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

/// The choice of both parameters and their values, `shown`; the sheet as a file and as a command; and, where
/// there is room for it, a sentence of one line.
void drawSheetControls(Session& session, SheetState& state, const SheetAxes& shown,
                       const std::function<void()>& sentence);

/// Why there is no sheet.
void sheetProblem(const std::string& words);

} // namespace texplorer::ui
