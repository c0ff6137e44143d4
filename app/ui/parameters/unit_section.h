#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void unitSection(const Session& session); ///< the selected unit and its environment

} // namespace texplorer::ui
