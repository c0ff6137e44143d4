#pragma once

#include "app/ui/figures/held_levels.h"
#include "app/ui/model/session.h"

namespace texplorer::ui {

struct CostFigureState {
    HeldLevels held; ///< of the bound texture
};

/// Draws what textures cost on the driver: a row for each claim, with the times that were measured.
void drawCostFigure(const Session& session, CostFigureState& state);

} // namespace texplorer::ui
