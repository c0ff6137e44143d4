#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The keys of the open lesson as they stand on a keyboard, what they do and what they have led to. A click
/// on one does the same. Nothing where the lesson has none.
void drawLessonKeys(Session& session, const LessonRun& run);

} // namespace texplorer::ui
