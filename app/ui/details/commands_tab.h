#pragma once

#include "app/ui/details/changed_paths.h"
#include "app/ui/model/session.h"
#include "core/emit/program.h"

#include <optional>
#include <string>
#include <vector>

namespace texplorer::ui {

/// A row of the list: a line of code, or a part of one that is too long.
struct CodeRow {
    std::vector<emit::Part> parts;
    std::size_t line;
    bool isLast; ///< of its line
};

/// What the tab remembers.
struct CommandsTabState {
    bool hasShownCalls = false; ///< the list was scrolled to the scene's own calls
    ChangedPaths revealed;      ///< the values that the list was scrolled to already

    // What was made of the scene, until there is what is made of another one.
    std::optional<Scene> scene;
    ImageSource images;
    std::string refused; ///< why there is no program; empty: there is one
    std::vector<emit::Line> lines;
    std::vector<CodeRow> rows;
    ChangedPaths changed; ///< whose lines glow, and stay though OpenGL has their values
    std::size_t columns = 0;
    bool rowsAreOld = false; ///< they are not those of `lines`
    bool rowsShowAll = false;
    std::string lastChanged;
};

/// The calls that draw the scene, in C, with their values as controls.
void drawCommandsTab(Session& session, CommandsTabState& state);

} // namespace texplorer::ui
