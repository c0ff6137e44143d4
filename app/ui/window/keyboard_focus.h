#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Whether the keyboard walks from control to control.
struct KeyboardFocus {
    bool walks = false;
};

/// F6, with Shift backwards, gives the keyboard to the next panel: then arrows walk among its controls, Space
/// and Enter work them. Escape, or a click, gives the keys their usual meaning back. Before the panels are
/// drawn.
void moveKeyboardFocus(Session& session, KeyboardFocus& focus);

} // namespace texplorer::ui
