#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void drawHelp(const Session& session); ///< the help of F1: keys, mouse and colours

} // namespace texplorer::ui
