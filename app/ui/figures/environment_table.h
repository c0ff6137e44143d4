#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct EnvironmentTableState {};

void drawEnvironmentTable(Session& session, EnvironmentTableState& state, const Pictures& pictures);

} // namespace texplorer::ui
