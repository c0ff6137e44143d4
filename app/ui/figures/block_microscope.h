#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct BlockMicroscopeState {};

void drawBlockMicroscope(Session& session, BlockMicroscopeState& state, const Pictures& pictures);

} // namespace texplorer::ui
