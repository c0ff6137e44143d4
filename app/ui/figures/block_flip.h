#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct BlockFlipState {};

void drawBlockFlip(Session& session, BlockFlipState& state, const Pictures& pictures);

} // namespace texplorer::ui
