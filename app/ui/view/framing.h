#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/show.h"

namespace texplorer::ui {

// Move the camera, each as an undo step. Until the user moves the camera, it follows the shape of the view.

/// Restores the initial camera, fitted to the view.
void resetCamera(const Session& session, const Layout& layout);
void frameAll(const Session& session, const Layout& layout);
void show(const Session& session, const ShowRow& row,
          const Layout& layout); ///< also selects the shown object

} // namespace texplorer::ui
