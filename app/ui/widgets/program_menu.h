#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Menu items for exporting the scene.
void programMenuItems(const Session& session);

} // namespace texplorer::ui
