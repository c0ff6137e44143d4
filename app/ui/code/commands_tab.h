#pragma once

#include "app/ui/model/session.h"
#include "texplorer/emit/code.h"
#include "texplorer/emit/program.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace texplorer::ui {

/// Paths of values in the scene, as the parts of emitted lines name them: "models[0].texCoords0[2]" is a
/// vertex's.
using ChangedPaths = std::set<std::string, std::less<>>;

/// A row of the list: a line of code, or a part of one that is too long.
struct CodeRow {
    std::vector<emit::Part> parts;
    std::size_t line;
    bool isLast; ///< of its line
};

/// The state of the tab.
struct CommandsTabState {
    bool hasShownCalls = false; ///< the list was scrolled to the scene's first call
    ChangedPaths revealed;      ///< the values that the list has already been scrolled to

    // The lines and the scene that they were made of; kept until those of the next scene are ready.
    std::optional<Scene> scene;
    ImageSource images;
    Sentence refused; ///< why there is no program; empty: there is one
    std::vector<emit::Line> lines;
    std::vector<CodeRow> rows;
    ChangedPaths changed; ///< their lines are highlighted, and stay even with OpenGL's initial value
    std::size_t columns = 0;
    bool rowsAreOld = false; ///< they do not match `lines`
    bool rowsShowAll = false;
    std::string lastChanged;
};

/// Draws the scene's calls in C, with their values as controls.
void drawCommandsTab(const Session& session, CommandsTabState& state);

/// The look of a piece of code.
struct CodeLook {
    float letter;   ///< width of a letter
    bool isFaint;   ///< the line sets OpenGL's initial value
    bool isChanged; ///< the line's value was changed last
};

/// Draws a part of a line at the cursor as a control: numbers can be dragged, choices have a list, switches
/// are clicked; the name of a call goes to its control. Returns its width.
float codePart(const Session& session, const emit::Part& part, const CodeLook& look);

/// Draws a swatch for the colour in a line, which opens the picker. Returns its width; 0 if the line has no
/// colour.
float codeSwatch(const Session& session, const emit::Line& line, const CodeLook& look);

} // namespace texplorer::ui
