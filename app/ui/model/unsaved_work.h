#pragma once

#include "app/ui/model/recovery.h"
#include "core/scene/storage/autosave.h"

namespace texplorer::ui {

struct Session;

/// Keeps unsaved work after a window ends. Owned by the host; must outlive the session.
struct UnsavedWork {
    explicit UnsavedWork(const std::filesystem::path& folder, const std::function<void()>& wake = {},
                         std::chrono::milliseconds delay = Autosave::usualDelay,
                         const Clock& clock = steadySeconds)
        : recovery(folder, wake)
        , autosave(folder, wake, delay, clock) {}

    Recovery recovery; ///< of earlier windows
    Autosave autosave; ///< of this window
};

/// Call at the end of a frame: keeps unsaved changes, removes the draft of saved or discarded ones, keeps
/// settings, and reports the workers' messages.
void followEdits(Session& session);

/// When it must be called again even if no frame is drawn, on the clock of Autosave and SettingsFile.
/// Nothing: not needed.
[[nodiscard]] std::optional<double> dueAt(const Session& session);

} // namespace texplorer::ui
