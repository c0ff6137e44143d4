#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// What the tab remembers.
struct CommandsTabState {
    std::string revealed; ///< the parameter that the list was scrolled to already
};

void drawCommandsTab(const Session& session, CommandsTabState& state);

} // namespace texplorer::ui
