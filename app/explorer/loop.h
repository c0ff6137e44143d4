#pragma once

#include "app/explorer/window.h"
#include "app/ui/session.h"

namespace texplorer::explorer {

/// Opens `files` and draws and edits the session in the window until the user closes it. Sleeps while nothing
/// moves and nothing is touched. The error says what the driver lacks.
[[nodiscard]] Result<void> runLoop(Window& window, ui::Session& session,
                                   const std::vector<std::filesystem::path>& files);

} // namespace texplorer::explorer
