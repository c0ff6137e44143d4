#pragma once

#include "texplorer/reference/explain/explanation.h"
#include "texplorer/reference/level_map_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

/// The levels that each pixel reads: shown as false colours over the pictures, and in the tab Levels.
struct LevelView {
    std::optional<reference::PixelPlace> hovered{}; ///< the pixel under the pointer, set by the view
    std::shared_ptr<const reference::LevelMapWorker::Answer>
        answer{}; ///< the newest; may be for an earlier question
};

} // namespace texplorer::ui
