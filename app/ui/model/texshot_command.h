#pragma once

#include "app/ui/model/session.h"
#include "app/view/size.h"

#include <string>
#include <string_view>

namespace texplorer::ui {

/// A command line for a shell that draws what the view shows: "texshot shot earth.json --set … -o earth.png".
/// Errors: what differs from the scene's file, or from the start, can't be said by --set.
[[nodiscard]] Result<std::string> texshotCommand(const Session& session, view::Size picture);

/// The same for the sheet that the window shows: "texshot sweep earth.json --axis … -o earth-sheet.png".
/// Errors: those, and of sheetOrder.
[[nodiscard]] Result<std::string> sweepCommand(const Session& session);

/// The same for the animation that the window would record: "texshot animate earth.json --fps … -o
/// earth.webp". Errors: those, and of recordingOf.
[[nodiscard]] Result<std::string> animateCommand(const Session& session);

} // namespace texplorer::ui
