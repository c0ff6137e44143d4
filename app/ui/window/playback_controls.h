#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawPlaybackControls(Session& session);
[[nodiscard]] float leastPlaybackWidth();   ///< in a bar with less room they are buttons alone
[[nodiscard]] float playbackButtonsWidth(); ///< and with less than this they are left out

} // namespace texplorer::ui
