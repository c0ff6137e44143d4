#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What one needs first, one click each, and below it the rows that the user has pinned.
void essentials(Session& session, const Pictures& pictures);

} // namespace texplorer::ui
