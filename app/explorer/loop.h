#pragma once

#include "app/explorer/signals.h"
#include "app/explorer/window.h"
#include "app/ui/model/session.h"

namespace texplorer::explorer {

/// Opens `files` and draws and edits the session in the window until the user closes it, or a signal asks for
/// it: then what is not saved is kept for the next start. `shaders`: the folder of the shader renderer's
/// files, empty: the built-in ones. Sleeps while nothing moves and nothing is touched. The error says what
/// the driver lacks.
[[nodiscard]] Result<void> runLoop(Window& window, ui::Session& session, Signals& signals,
                                   const std::vector<std::filesystem::path>& files,
                                   const std::filesystem::path& shaders = {});

} // namespace texplorer::explorer
