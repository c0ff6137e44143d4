#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Draws the step of the open lesson: its texts, its question or task, and the buttons to other steps.
/// Without an open lesson it draws the list of all lessons.
void drawLessonTab(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
