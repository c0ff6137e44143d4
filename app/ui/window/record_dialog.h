#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Dialog::Record: the options of an animation, before its file is chosen.
void drawRecord(const Session& session);

} // namespace texplorer::ui
