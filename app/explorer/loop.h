#pragma once

#include "app/explorer/signals.h"
#include "app/explorer/window.h"
#include "app/view/pretence.h"

namespace texplorer::explorer {

/// Opens `files` and shows and edits them in the window until the user closes it, or a signal asks for
/// it: then what is not saved is kept for the next start. `lesson`: its name or folder, empty: none.
/// `shaders`: the folder of the shader renderer's files, empty: the built-in ones. `pretence`: what the
/// driver is treated as lacking. Sleeps while nothing moves and nothing is touched. The error says what the
/// driver lacks.
[[nodiscard]] Result<void> runLoop(Window& window, Signals& signals,
                                   const std::vector<std::filesystem::path>& files, const std::string& lesson,
                                   const std::filesystem::path& shaders = {},
                                   const view::Pretence& pretence = {});

} // namespace texplorer::explorer
