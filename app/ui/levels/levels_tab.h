#pragma once

#include "app/ui/levels/level_strip_drawing.h"

namespace texplorer::ui {

/// Draws the levels of the selected unit's texture in a row, and which of them a pixel reads.
void drawLevelsTab(const Session& session, LevelsTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
