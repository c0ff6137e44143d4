#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct TextureObjectsState {};

void drawTextureObjects(Session& session, TextureObjectsState& state, const Pictures& pictures);

} // namespace texplorer::ui
