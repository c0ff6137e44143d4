#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// Beside the label of a parameter: says what is wrong with it, and after a click what mends it.
void problemSign(Session& session, const std::string& path, const Finding& problem);

} // namespace texplorer::ui
