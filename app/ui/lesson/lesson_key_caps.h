#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Draws the keys of the open lesson, their actions and current effects. A click acts like the key. Does
/// nothing if the lesson has no keys.
void drawLessonKeys(const Session& session, const LessonRun& run);

} // namespace texplorer::ui
