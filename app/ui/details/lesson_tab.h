#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The step of the lesson that is open: what it says, what it asks, and the way on. Without one the list of
/// all lessons.
void drawLessonTab(Session& session, const Pictures& pictures);

} // namespace texplorer::ui
