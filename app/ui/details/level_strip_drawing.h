#pragma once

#include "app/ui/details/levels_tab.h"
#include "core/texture/levels_worker.h"

namespace texplorer::ui {

/// The strip of the levels in what is left of the panel but `below` pixels: each level's picture, number and
/// size, and below them the scale of λ. A click reads a level alone, the handles limit what is read, the
/// wheel enlarges. There is at least one level.
void drawLevelStrip(Session& session, LevelsTabState& state, const Pictures& pictures,
                    const LevelsSummary& summary, float below);

} // namespace texplorer::ui
