#pragma once

#include "app/ui/model/session.h"
#include "app/ui/state/layout.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Whether hints are for fingers: in a page, which has their gestures, with large controls.
[[nodiscard]] bool areHintsForFingers(const Session& session);

void drawViewPanel(const Session& session, const Pictures& pictures, const Layout& layout);

} // namespace texplorer::ui
