#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// What the keys of the open lesson do goes before the window's shortcuts: those that are held are taken.
/// `popup`: a menu or a list has the keyboard. Before the panels are drawn.
void takeLessonKeys(Session& session, bool popup);

} // namespace texplorer::ui
