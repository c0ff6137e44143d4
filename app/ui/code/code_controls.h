#pragma once

#include "app/ui/model/session.h"
#include "texplorer/emit/code.h"

#include <imgui.h>

namespace texplorer::ui {

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
