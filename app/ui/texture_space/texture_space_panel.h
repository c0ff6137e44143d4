#pragma once

#include "app/ui/state/layout.h"
#include "app/ui/texture_space/texture_space_state.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

void drawTextureSpacePanel(const Session& session, TextureSpaceState& state, const Pictures& pictures,
                           const Layout& layout);

} // namespace texplorer::ui
