#pragma once

#include "app/ui/model/layout.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

/// If it is on, dims everything except a disc around the pointer, to direct an audience. Call it after
/// everything else is drawn.
void drawSpotlight(const Session& session, const Layout& layout);

} // namespace texplorer::ui
