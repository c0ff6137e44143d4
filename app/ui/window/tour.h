#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// A small card beside what it talks about: the step that WindowState::tour names. When it ends, the settings
/// remember that it was seen. `takesEscape`: the key doesn't end something else with this frame.
void drawTour(Session& session, const Layout& layout, bool takesEscape);

} // namespace texplorer::ui
