#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The mouse over the pictures: E held explains the pixel below it, a click does where the tab is open.
void probeWithMouse(Session& session, const Panes& panes, bool hovered, bool clicked);

/// The pixels that the chosen texel has a share in, and the sign of the probed one.
void drawProbedPixel(const Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane);

} // namespace texplorer::ui
