#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"
#include "texplorer/texture/levels_worker.h"

#include <optional>
#include <string>

namespace texplorer::ui {

/// How the levels are drawn.
struct LevelsTabState {
    bool equal = false; ///< all levels are drawn in one size
    float zoom = 1;
    int face = 0; ///< of a cube map, the shown one: see cubeFaceAt
};

/// The levels of the bound texture; without an image, writes that there is none.
[[nodiscard]] std::optional<LevelsRequest> requestLevels(const Session& session);

/// "128 × 64"; the length of a line, three extents of a volume.
[[nodiscard]] std::string levelExtentsText(const LevelReport& level, Target target);

/// Draws the strip of levels into the rest of the panel, except `below` pixels: each level's picture, number
/// and size, and below them the scale of λ. A click selects a single level, the handles limit the range, the
/// wheel zooms. There must be at least one level.
void drawLevelStrip(const Session& session, LevelsTabState& state, const Pictures& pictures,
                    const LevelsSummary& summary, float below);

/// Draws the levels of the selected unit's texture in a row, and which of them a pixel reads.
void drawLevelsTab(const Session& session, LevelsTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
