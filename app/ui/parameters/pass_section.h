#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Buttons that choose the pass whose units and state are shown; a dot marks those that are drawn. Nothing
/// where there is one pass.
void passChoice(Session& session);

/// The passes: added, removed, exchanged; and the state of the one that is chosen.
void passSection(Session& session);

} // namespace texplorer::ui
