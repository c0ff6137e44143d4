#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The contents of the menu "Presets": grouped, each previewed while the pointer rests on it.
void drawPresetsMenu(const Session& session);

} // namespace texplorer::ui
