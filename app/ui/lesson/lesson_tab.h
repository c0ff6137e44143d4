#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Draws the step of the open lesson: its texts, its question or task, and the buttons to other steps.
/// Without an open lesson it draws the list of all lessons.
void drawLessonTab(const Session& session, const Pictures& pictures);

/// Draws the keys of the open lesson, their actions and current effects. A click acts like the key. Does
/// nothing if the lesson has no keys.
void drawLessonKeys(const Session& session, const LessonRun& run);

} // namespace texplorer::ui
