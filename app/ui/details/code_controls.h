#pragma once

#include "app/ui/model/session.h"
#include "core/emit/code.h"

#include <imgui.h>

namespace texplorer::ui {

/// How a piece of code is drawn.
struct CodeLook {
    float letter;   ///< how wide a letter is
    bool isFaint;   ///< the line sets what OpenGL has anyway
    bool isChanged; ///< the line's value is the one that changed last
};

/// Draws a part of a line at the cursor, as the control that its value is: numbers are dragged, choices have
/// a list, switches are clicked; the name of a call leads to its control. The width that it took.
float codePart(Session& session, const emit::Part& part, const CodeLook& look);

/// A swatch of the colour whose numbers a line has, which opens the picker. The width that it took; 0: it is
/// no colour.
float codeSwatch(Session& session, const emit::Line& line, const CodeLook& look);

} // namespace texplorer::ui
