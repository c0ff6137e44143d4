#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The state of the tab.
struct LevelsTabState {
    bool equal = false; ///< all levels are drawn in one size
    float zoom = 1;
    int face = 0; ///< of a cube map, the shown one: see cubeFaceAt

    static constexpr float maxZoom = 64;
};

/// Draws the levels of the selected unit's texture in a row, and which of them a pixel reads.
void drawLevelsTab(const Session& session, LevelsTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
