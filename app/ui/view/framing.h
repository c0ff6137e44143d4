#pragma once

#include "app/ui/model/session.h"
#include "app/ui/view/show.h"

namespace texplorer::ui {

/// Width / height of the pictures.
[[nodiscard]] float aspectOf(const Layout& layout);

// What aims the camera, each a step of undo.

/// The camera as it was at the start, fitted to the view.
void resetCamera(Session& session, const Layout& layout);
void frameAll(Session& session, const Layout& layout);
void show(Session& session, const ShowRow& row, const Layout& layout); ///< selects what is shown, too

} // namespace texplorer::ui
