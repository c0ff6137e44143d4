#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

void drawViewPanel(const Session& session, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui
