#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct EdgeLensState {};

void drawEdgeLens(Session& session, EdgeLensState& state, const Pictures& pictures);

} // namespace texplorer::ui
