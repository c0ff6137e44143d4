#pragma once

#include "app/ui/model/session.h"

#include <optional>

namespace texplorer::ui {

/// Call at the end of a frame: keeps unsaved changes, removes the draft of saved or discarded ones, keeps
/// settings, and reports the workers' messages.
void followEdits(Session& session);

/// When it must be called again even if no frame is drawn, on the clock of Autosave and SettingsFile.
/// Nothing: not needed.
[[nodiscard]] std::optional<double> dueAt(const Session& session);

} // namespace texplorer::ui
