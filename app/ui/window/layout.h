#pragma once

#include "app/ui/state/layout.h"
#include "app/ui/state/workspace.h"

namespace texplorer::ui {

/// Pure: the result depends only on the arguments. `scale` is the monitor's content scale, and large controls
/// are those for fingers.
[[nodiscard]] Layout layoutFor(int width, int height, float scale, const Workspace& workspace = {},
                               PaneGrid grid = {}, bool largeControls = false);

} // namespace texplorer::ui
