#pragma once

#include "app/ui/model/recovery.h"
#include "core/autosave/autosave.h"

namespace texplorer::ui {

struct Session;

/// What keeps unsaved work beyond the end of a window. The host makes one and lends it to the session.
struct UnsavedWork {
    explicit UnsavedWork(const std::filesystem::path& folder, const std::function<void()>& wake = {},
                         std::chrono::milliseconds delay = Autosave::usualDelay,
                         const Clock& clock = steadySeconds)
        : recovery(folder, wake)
        , autosave(folder, wake, delay, clock) {}

    Recovery recovery; ///< of windows before this one
    Autosave autosave; ///< of this one
};

/// To be called at the end of a frame: what would be lost now is kept, what is saved or given up is not, and
/// so are settings; what workers have to say of them is said.
void followEdits(Session& session);

/// When that has to be called again even if no frame is drawn, on the clock of what is kept. Nothing: it
/// need not.
[[nodiscard]] std::optional<double> dueAt(const Session& session);

} // namespace texplorer::ui
