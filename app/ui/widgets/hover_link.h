#pragma once

#include "app/ui/model/session.h"

#include <string_view>

namespace texplorer::ui {

/// The last widget belongs to a parameter: where the pointer rests on it, every panel that shows the
/// parameter lights it with the next frame; where it rests on another of them, this one is lit.
void linkHover(Session& session, std::string_view path);

/// Called once a frame, before all panels.
void turnHover(WindowState& window);

} // namespace texplorer::ui
