#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What the tab remembers.
struct LevelsTabState {
    bool equal = false; ///< all levels have one size
    float zoom = 1;
    int face = 0; ///< of a cube map, the one that is shown: see cubeFaceAt

    static constexpr float largestZoom = 64;
};

/// The levels of the texture of the selected unit beside each other, and which of them a pixel reads.
void drawLevelsTab(Session& session, LevelsTabState& state, const Pictures& pictures);

} // namespace texplorer::ui
