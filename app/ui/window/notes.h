#pragma once

#include "app/ui/model/layout.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// A new note where the pointer is over the pictures, to be typed at once. Elsewhere nothing happens.
void addNoteAtPointer(Session& session, const Layout& layout);
/// The same where a menu can't point: in the middle, each a little below the one before it.
void addNoteInTheMiddle(Session& session);
void clearNotes(Session& session);

/// Over the view. A drag moves one, a double click edits it, Delete removes the chosen one.
void drawNotes(Session& session, const Layout& layout);

} // namespace texplorer::ui
