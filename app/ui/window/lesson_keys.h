#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Handles the keys of the open lesson before the window's shortcuts and removes them from the input.
/// `popup`: a menu or a list has the keyboard. Call it before the panels are drawn.
void takeLessonKeys(Session& session, bool popup);

} // namespace texplorer::ui
