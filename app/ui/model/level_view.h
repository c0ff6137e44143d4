#pragma once

#include "app/view/size.h"
#include "core/reference/explain/explanation.h"
#include "core/reference/level_map_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

struct Session;

/// What the user sees of the levels that each pixel reads: as false colours over the pictures, and in the tab
/// Levels.
struct LevelView {
    std::optional<reference::PixelPlace> hovered{}; ///< the pixel under the pointer, kept by the view
    std::shared_ptr<const reference::LevelMapWorker::Answer>
        answer{}; ///< the newest; may be an earlier one's
};

/// To be called once a frame, before the panels: asks for the levels of the pixels, where somebody looks at
/// them, and takes what there is by now. A picture has this size in pixels.
void askAboutLevels(Session& session, view::Size picture);

/// The map that there is, of the selected unit; nullptr: none yet, or the answer says why not.
[[nodiscard]] const reference::LevelMap* levelMapOf(const Session& session);

/// The pixel that one asks about: the one under the pointer, else the one that is explained.
[[nodiscard]] std::optional<reference::PixelPlace> askedPixel(const Session& session);

/// What the selected unit read at that pixel; nullptr: nothing, or nothing is known.
[[nodiscard]] const reference::PixelLevels* askedLevels(const Session& session);

} // namespace texplorer::ui
