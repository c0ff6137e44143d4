#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct SheetState {};

void drawSheet(Session& session, SheetState& state, const Pictures& pictures);

} // namespace texplorer::ui
