#pragma once

#include "app/ui/widgets/param_widgets.h"

namespace texplorer::ui {

/// The usual degrees of anisotropy as buttons, and a slider that ends where the driver's do.
void anisotropyLine(Session& session, const Owner& texture, const ParamRow& row);

/// Where the slider ends: at the largest that the driver has, or where it has none, at that of the reference
/// renderer, which is the row's.
[[nodiscard]] float mostAnisotropy(float driver, const ParamRow& row);

} // namespace texplorer::ui
