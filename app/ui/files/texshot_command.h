#pragma once

#include "app/ui/model/session.h"
#include "app/view/size.h"

#include <string>

namespace texplorer::ui {

/// A command line for a shell that draws the view's picture: "texshot shot earth.json --set … -o earth.png".
/// Fails if
/// --set cannot express the differences from the scene's file, or from the default scene.
[[nodiscard]] Result<std::string> texshotCommand(const Session& session, view::Size picture);

/// The same for the shown sheet: "texshot sweep earth.json --axis … -o earth-sheet.png". Errors: those, and
/// those of sheetOrder.
[[nodiscard]] Result<std::string> sweepCommand(const Session& session);

/// The same for a recording: "texshot animate earth.json --fps … -o earth.webp". Errors: those, and those of
/// recordingOf.
[[nodiscard]] Result<std::string> animateCommand(const Session& session);

} // namespace texplorer::ui
