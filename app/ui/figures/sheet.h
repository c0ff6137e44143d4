#pragma once

#include "app/ui/figures/sheet_controls.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// Draws the scene with every pair of values of two parameters, as small pictures by the reference. A click
/// sets both values.
void drawSheet(const Session& session, SheetState& state, const Pictures& pictures);

} // namespace texplorer::ui
