#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Dialog::FileHasChanged.
void drawChangedFile(const Session& session);

} // namespace texplorer::ui
