#pragma once

#include "app/ui/services/recovery.h"
#include "texplorer/scene/storage/autosave.h"

namespace texplorer::ui {

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

} // namespace texplorer::ui
