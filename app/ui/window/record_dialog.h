#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Dialog::Record: how an animation is recorded, before its file is chosen.
void drawRecord(Session& session);

} // namespace texplorer::ui
