#pragma once

#include "app/ui/model/selection.h"
#include "core/scene/edit/edit.h"

#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// An action of the user that edits the scene: a step of undo. Panels submit steps; the editor makes them at
/// the end of the frame, so that the scene stays the same while panels are drawn.
struct Step {
    std::string name;        ///< in undo: "Wrap s: Repeat"
    std::vector<Edit> edits; ///< all are made, or none
    std::string path{};      ///< the changed parameter, if it is one
    bool continues = false;  ///< with others of its name, as in a drag, one step of undo until sealEdit
    std::optional<Selection> select{}; ///< what is selected afterwards, as far as it exists
    std::string says{};                ///< in the status bar afterwards
};

} // namespace texplorer::ui
