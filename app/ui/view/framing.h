#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/show.h"

namespace texplorer::ui {

// What aims the camera, each a step of undo. Until somebody moves it, it follows the shape of the view.

/// The camera as it was at the start, fitted to the view.
void resetCamera(Session& session, const Layout& layout);
void frameAll(Session& session, const Layout& layout);
void show(Session& session, const ShowRow& row, const Layout& layout); ///< selects what is shown, too

} // namespace texplorer::ui
