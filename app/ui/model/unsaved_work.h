#pragma once

#include "app/ui/model/recovery.h"
#include "core/autosave/autosave.h"

namespace texplorer::ui {

struct Session;

/// What keeps unsaved work beyond the end of a window. The host makes one and lends it to the session.
struct UnsavedWork {
    explicit UnsavedWork(const std::filesystem::path& folder, const std::function<void()>& wake = {},
                         std::chrono::milliseconds delay = Autosave::usualDelay)
        : recovery(folder, wake)
        , autosave(folder, wake, delay) {}

    Recovery recovery; ///< of windows before this one
    Autosave autosave; ///< of this one
};

/// To be called at the end of a frame: what would be lost now is kept, what is saved or given up is not.
void followEdits(Session& session);

} // namespace texplorer::ui
