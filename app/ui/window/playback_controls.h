#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawPlaybackControls(const Session& session);
[[nodiscard]] float minPlaybackWidth();     ///< with less room they are only buttons
[[nodiscard]] float playbackButtonsWidth(); ///< with less room they are left out

} // namespace texplorer::ui
