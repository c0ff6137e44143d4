#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Handles the mouse over the pictures: holding E explains the pixel below it, and so does a click if the tab
/// is open.
void probeWithMouse(const Session& session, const Panes& panes, bool hovered, bool clicked);

/// Draws the pixels that use the selected texel, and the mark of the probed one.
void drawProbedPixel(const Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane);

} // namespace texplorer::ui
