#pragma once

#include "app/ui/state/selection.h"
#include "texplorer/scene/scene.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// A: the state of a document that the user kept, for comparisons with the current state. Undo does not
/// change it.
struct Kept {
    std::shared_ptr<const Scene> scene; ///< nullptr: no state is kept
    /// The same scene with the current camera, for the view. nullptr: the view does not draw it.
    std::shared_ptr<const Scene> seen;
    /// The current scene while the view shows A: any edit except of the camera switches back to the current
    /// scene.
    std::optional<Scene> flippedAt;
    Selection selection{}; ///< at the time when it was kept
};

} // namespace texplorer::ui
