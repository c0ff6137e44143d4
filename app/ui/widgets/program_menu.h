#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// In a menu: what the scene may be exported as.
void programMenuItems(Session& session);

} // namespace texplorer::ui
