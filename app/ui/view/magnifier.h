#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Draws the pixels around the mouse enlarged, with the position and the colour of the one under it, for
/// every shown picture side by side. Does nothing if it is switched off. Call it while the mouse is on the
/// pictures.
void drawMagnifier(const Session& session, const Panes& panes, const Pictures& pictures,
                   const Layout& layout);

} // namespace texplorer::ui
