#pragma once

#include "app/view/size.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/reference/level_map_worker.h"

#include <optional>

namespace texplorer::ui {

struct Session;

/// Call once per frame, before the panels. Asks for the levels of the pixels if a panel shows them, and takes
/// finished answers. A picture has this size in pixels.
void askAboutLevels(Session& session, view::Size picture);

/// The current map of the selected unit; nullptr: none yet, or see the answer's problem.
[[nodiscard]] const reference::LevelMap* levelMapOf(const Session& session);

/// The queried pixel: the one under the pointer, else the one that is explained.
[[nodiscard]] std::optional<reference::PixelPlace> askedPixel(const Session& session);

/// What the selected unit read at that pixel; nullptr: nothing, or not known.
[[nodiscard]] const reference::PixelLevels* askedLevels(const Session& session);

} // namespace texplorer::ui
