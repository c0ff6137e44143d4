#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Whether the keyboard moves between controls.
struct KeyboardFocus {
    bool walks = false;
};

/// F6, with Shift backwards, moves the keyboard focus to the next panel: arrows then move between its
/// controls, Space and Enter activate them. Escape, or a click, restores the usual meaning of the keys. Call
/// it before the panels are drawn.
void moveKeyboardFocus(const Session& session, KeyboardFocus& focus);

} // namespace texplorer::ui
