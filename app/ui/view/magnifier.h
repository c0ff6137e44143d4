#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/panes.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The pixels around the mouse, enlarged, with the place and the colour of the one under it: of every picture
/// that is shown, side by side. Does nothing where it is switched off; to be called while the mouse is on the
/// pictures.
void drawMagnifier(Session& session, const Panes& panes, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui
