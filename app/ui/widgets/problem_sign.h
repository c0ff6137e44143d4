#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// A sign next to the label of a parameter: shows its problem, and after a click the fixes.
void problemSign(const Session& session, const std::string& path, const Finding& problem);

} // namespace texplorer::ui
