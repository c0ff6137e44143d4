#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

void drawMemoryTab(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
