#pragma once

#include "app/ui/details/levels_tab.h"
#include "core/texture/levels_worker.h"

namespace texplorer::ui {

/// Draws the strip of levels into the rest of the panel, except `below` pixels: each level's picture, number
/// and size, and below them the scale of λ. A click selects a single level, the handles limit the range, the
/// wheel zooms. There must be at least one level.
void drawLevelStrip(const Session& session, LevelsTabState& state, const Pictures& pictures,
                    const LevelsSummary& summary, float below);

} // namespace texplorer::ui
