#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

void drawRestore(const Session& session, const Pictures& pictures); ///< there must be an offer

} // namespace texplorer::ui
