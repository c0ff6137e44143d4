#pragma once

#include "app/ui/model/layout.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Where it is on: all but a disc around the pointer becomes dim, so that an audience looks there. To be
/// called after everything else is drawn.
void drawSpotlight(const Session& session, const Layout& layout);

} // namespace texplorer::ui
