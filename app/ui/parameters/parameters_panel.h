#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

void drawParametersPanel(Session& session, const Layout& layout, const Pictures& pictures);

} // namespace texplorer::ui
