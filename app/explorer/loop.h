#pragma once

#include "app/explorer/signals.h"
#include "app/explorer/window.h"
#include "app/view/pretence.h"

namespace texplorer::explorer {

/// Opens `files` and shows them in the window until the user closes it or a signal ends the program; a signal
/// keeps unsaved work for the next start. `lesson`: its name or folder, empty: none. `shaders`: the folder
/// with the shader renderer's files, empty: the built-in ones. `pretence`: features that the driver is
/// treated as lacking. Sleeps while nothing changes. The error says what the driver lacks.
[[nodiscard]] Result<void> runLoop(Window& window, Signals& signals,
                                   const std::vector<std::filesystem::path>& files, const std::string& lesson,
                                   const std::filesystem::path& shaders = {},
                                   const view::Pretence& pretence = {});

} // namespace texplorer::explorer
