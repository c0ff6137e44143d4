#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void unitSection(Session& session); ///< the selected unit and its environment

} // namespace texplorer::ui
