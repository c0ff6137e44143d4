#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The contents of the menu "A/B".
void drawKeptMenu(Session& session);

/// In the menu bar's row: one button while nothing is kept, else what the view shows. Nothing where there is
/// less room than that; the menu has it all.
void drawKeptControls(Session& session, float available);

/// How wide they are.
[[nodiscard]] float keptControlsWidth(const Session& session);

} // namespace texplorer::ui
