#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawPlaybackControls(Session& session);
[[nodiscard]] float leastPlaybackWidth(); ///< they are left out of a bar with less room

} // namespace texplorer::ui
