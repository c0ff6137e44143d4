#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Buttons to select the pass whose units and state are shown; a dot marks those that are drawn. Does nothing
/// if there is one pass.
void passChoice(const Session& session);

/// The passes: add, remove, reorder; and the state of the selected one.
void passSection(const Session& session);

} // namespace texplorer::ui
