#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// The state of the controls.
struct SheetState {
    std::array<std::string, 2> typed; ///< the texts in the fields of values
    SheetAxes typedOf;                ///< the axes that the fields belong to
    std::string search;               ///< text to find another parameter
    /// A parameter to choose from.
    struct Offer {
        std::string path;
        std::string label;
    };
    std::vector<Offer> offers; ///< the matching parameters
    bool isOffered = false;    ///< `offers` match `search`
};

/// Draws the scene with every pair of values of two parameters, as small pictures by the reference. A click
/// sets both values.
void drawSheet(const Session& session, SheetState& state, const Pictures& pictures);

/// Draws the choice of both parameters and their values, `shown`; buttons for the sheet as a file and as a
/// command; and, if there is room, one line of text.
void drawSheetControls(const Session& session, SheetState& state, const SheetAxes& shown,
                       const std::function<void()>& sentence);

/// Shows why there is no sheet.
void sheetProblem(const Sentence& words);

} // namespace texplorer::ui
