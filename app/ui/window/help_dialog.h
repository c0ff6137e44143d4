#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawHelp(Session& session); ///< what F1 shows: keys, mouse and colours

} // namespace texplorer::ui
