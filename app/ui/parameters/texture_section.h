#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The texture bound to the selected unit.
void textureSection(const Session& session, const Pictures& pictures);

} // namespace texplorer::ui
