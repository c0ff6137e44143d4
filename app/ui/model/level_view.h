#pragma once

#include "app/view/size.h"
#include "texplorer/reference/explain/explanation.h"
#include "texplorer/reference/level_map_worker.h"
#include "texplorer/texture/levels_worker.h"

#include <memory>
#include <optional>

namespace texplorer::ui {

struct Session;

/// Call once per frame, before the panels. Asks for the levels of the pixels if a panel shows them, and takes
/// finished answers. A picture has this size in pixels.
void askAboutLevels(Session& session, view::Size picture);

/// Call once per frame, before the panels. Asks for the levels of the textures of the selected pass, so that
/// `summaryOf` knows the quick ones already while their scene is edited.
void askAboutTextures(Session& session);

[[nodiscard]] LevelsRequest levelsOf(const Session& session, const Texture& texture, Target target);
/// Of the texture that is bound to the selected unit; nothing: none is bound, or its image is not loaded.
[[nodiscard]] std::optional<LevelsRequest> boundLevels(const Session& session);

/// The facts about levels, with small pictures; nullptr: none yet. Requests the levels if needed.
[[nodiscard]] std::shared_ptr<const LevelsSummary> summaryOf(const Session& session,
                                                             const LevelsRequest& request);

/// The current map of the selected unit; nullptr: none yet, or see the answer's problem.
[[nodiscard]] const reference::LevelMap* levelMapOf(const Session& session);

/// The queried pixel: the one under the pointer, else the one that is explained.
[[nodiscard]] std::optional<reference::PixelPlace> askedPixel(const Session& session);

/// What the selected unit read at that pixel; nullptr: nothing, or not known.
[[nodiscard]] const reference::PixelLevels* askedLevels(const Session& session);

} // namespace texplorer::ui
