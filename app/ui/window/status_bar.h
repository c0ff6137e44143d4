#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "app/view/capabilities.h"

namespace texplorer::ui {

void drawStatusBar(Session& session, const Pictures& pictures, const view::Capabilities& capabilities,
                   const Layout& layout);

} // namespace texplorer::ui
