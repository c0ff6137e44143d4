#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// A small card next to its subject, for the step WindowState::tour. At its end the settings store that it
/// was seen. `takesEscape`: Escape ends the tour, unless it has another effect in this frame.
void drawTour(const Session& session, const Layout& layout, bool takesEscape);

} // namespace texplorer::ui
