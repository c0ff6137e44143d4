#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Menu items for exporting the scene.
void programMenuItems(Session& session);

} // namespace texplorer::ui
