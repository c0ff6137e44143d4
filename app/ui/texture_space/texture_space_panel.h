#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// What the panel remembers.
struct TextureSpaceState {
    bool movesVertex = false; ///< the drag holds a vertex, not the plane
};

void drawTextureSpacePanel(Session& session, TextureSpaceState& state, const Pictures& pictures,
                           const Layout& layout);

} // namespace texplorer::ui
