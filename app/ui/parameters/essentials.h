#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Draws the most important parameters, one click each, and below them the rows that the user has pinned.
void essentials(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
