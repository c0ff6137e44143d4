#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void coordinatesSection(const Session& session); ///< generated ones, of the selected unit

} // namespace texplorer::ui
