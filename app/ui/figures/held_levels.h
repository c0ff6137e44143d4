#pragma once

#include "app/ui/model/session.h"
#include "texplorer/base/sentence.h"
#include "texplorer/texture/levels_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// The levels of a texture for a figure, which a worker makes.
struct HeldLevels {
    std::optional<LevelsRequest> request{};
    std::shared_ptr<const PreparedLevels> levels{}; ///< of that request; nullptr: not ready
    Sentence problem{};                             ///< why there are none to show
};

/// Freeing large levels takes a while.
void giveLevelsBack(LevelsWorker& worker, HeldLevels& held);

/// Requests the levels until they are ready. `wanted`: nothing if there is no image. Returns whether others
/// are held.
bool followLevels(LevelsWorker& worker, HeldLevels& held, std::optional<LevelsRequest> wanted);

} // namespace texplorer::ui
