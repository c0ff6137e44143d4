#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

struct EmbossTheoryState {};

void drawEmbossTheory(Session& session, EmbossTheoryState& state, const Pictures& pictures);

} // namespace texplorer::ui
