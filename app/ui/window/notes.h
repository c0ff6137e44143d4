#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

namespace texplorer::ui {

/// Adds a note at the pointer, ready to be typed. Does nothing if the pointer is not over the pictures.
void addNoteAtPointer(Session& session, const Layout& layout);
/// The same for a menu: in the middle, each slightly below the previous one.
void addNoteInTheMiddle(Session& session);
void clearNotes(Session& session);

/// Draws the notes over the view. A drag moves a note, a double click edits it, Delete removes the selected
/// one.
void drawNotes(const Session& session, const Layout& layout);

} // namespace texplorer::ui
