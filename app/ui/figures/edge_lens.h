#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The state: a row of texels with its two edges.
struct EdgeLensState {
    int size = 4;       ///< of the row
    float s = -0.0625F; ///< the coordinate that is sampled
};

/// Shows which texels of a row are mixed at each coordinate from -1 to 2, with the wrap mode and the filter
/// of the bound texture. A click on a mode sets it in the scene.
void drawEdgeLens(const Session& session, EdgeLensState& state);

} // namespace texplorer::ui
