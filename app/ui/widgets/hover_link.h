#pragma once

#include "app/ui/model/session.h"

#include <string_view>

namespace texplorer::ui {

/// Links the last widget to a parameter: while the pointer is on it, every panel highlights the parameter
/// from the next frame on; while the pointer is on another widget of the parameter, this one is highlighted.
void linkHover(const Session& session, std::string_view path);

} // namespace texplorer::ui
