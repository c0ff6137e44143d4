#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"

namespace texplorer::ui {

/// Call before a frame is rendered and its panels are drawn: fits a camera that needs it, and corrects
/// selections that are not in the scene.
void settle(Session& session, const Layout& layout);

} // namespace texplorer::ui
