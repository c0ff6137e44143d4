#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The contents of the menu "A/B".
void drawKeptMenu(const Session& session);

/// Controls in the menu bar: one button while no state is kept, else the choice of what the view shows. Does
/// nothing if there is less room; the menu has everything.
void drawKeptControls(const Session& session, float available);

/// Their width.
[[nodiscard]] float keptControlsWidth(const Session& session);

} // namespace texplorer::ui
