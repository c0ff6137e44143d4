#pragma once

#include "app/explorer/frame_watch.h"
#include "app/explorer/restart.h"
#include "app/explorer/signals.h"
#include "app/explorer/window.h"
#include "app/view/pretence.h"
#include "texplorer/scene/renderer.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace texplorer::explorer {

/// What the window belongs to. All must outlive the loop.
struct Host {
    Window& window;
    Signals& signals;
    FrameWatch& watch;
    Restart& restart;
};

/// How a window begins.
struct Beginning {
    std::vector<std::filesystem::path> files;
    std::string lesson;                   ///< its name or folder; empty: none
    std::filesystem::path shaders;        ///< the shader renderer's files; empty: the built-in ones
    view::Pretence pretence;              ///< features that the driver is treated as lacking
    std::optional<RendererKind> renderer; ///< nothing: the best one
    std::optional<double> hungFor;        ///< the seconds in which the driver did not finish: see Restart
};

/// Opens the files and shows them in the window until the user closes it or a signal ends the program; a
/// signal keeps unsaved work for the next start. If the driver hangs, the program starts again with the
/// reference renderer. Sleeps while nothing changes. The error says what the driver lacks.
[[nodiscard]] Result<void> runLoop(const Host& host, const Beginning& beginning);

/// What Restart shows of it before the loop has begun.
[[nodiscard]] std::vector<std::string> argumentsOf(const Beginning& beginning);

} // namespace texplorer::explorer
