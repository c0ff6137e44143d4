#pragma once

#include "app/ui/state/sections.h"
#include "app/ui/state/selection.h"
#include "texplorer/scene/edit/edit.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace texplorer::ui {

struct Session;

/// An action of the user that edits the scene: a step of undo. Panels submit steps; the editor makes them at
/// the end of the frame, so that the scene stays the same while panels are drawn.
struct Step {
    Sentence name;           ///< in undo: "Wrap s: Repeat"
    std::vector<Edit> edits; ///< all are made, or none
    std::string path{};      ///< the changed parameter, if it is one
    bool continues = false;  ///< with others of its name, as in a drag, one step of undo until sealEdit
    std::optional<Selection> select{}; ///< what is selected afterwards, as far as it exists
    Sentence says{};                   ///< in the status bar afterwards
};

struct EndStep {};  ///< ends the undo step of a drag: the next edit starts a new one even with the same name
struct DropStep {}; ///< removes the undo step of a drag that has not ended
struct Undo {};
struct Redo {};
/// Undoes or redoes until the step of the history.
struct GoToStep {
    std::size_t step = 0;
};

/// Anything but an edit: changes the window's state, opens, saves or starts something.
using Action = std::function<void(Session&)>;

using Request = std::variant<Step, EndStep, DropStep, Undo, Redo, GoToStep, Action>;

/// What panels say while they are drawn. They only read the rest of the session.
struct Outbox {
    std::vector<Request> requests;          ///< made at the end of the frame, in this order
    std::string hoveredParam;               ///< under the pointer: all panels highlight it in the next frame
    std::string wantedParam;                ///< the parameter to scroll to, until it is shown; empty: none
    std::optional<Section> wantedSection{}; ///< to open and scroll to, until it is shown
    bool wantsSearch = false;               ///< the parameter search gets the keyboard
    bool keyTaken = false;                  ///< a panel has used a key of this frame: it is not a shortcut
    bool isOutdated = false;    ///< an answer has arrived after the panels: another frame shows it
    bool movesVertices = false; ///< vertices are being moved in texture space: other edits wait
};

} // namespace texplorer::ui
