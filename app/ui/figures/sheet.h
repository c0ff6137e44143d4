#pragma once

#include "app/ui/figures/sheet_controls.h"
#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

namespace texplorer::ui {

/// The scene with every pair of values of two parameters, small, as the reference draws it. A click takes
/// both values.
void drawSheet(Session& session, SheetState& state, const Pictures& pictures);

} // namespace texplorer::ui
