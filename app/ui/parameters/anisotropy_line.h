#pragma once

#include "app/ui/widgets/param_widgets.h"

namespace texplorer::ui {

/// Draws the usual degrees of anisotropy as buttons, and a slider up to the driver's limit.
void anisotropyLine(const Session& session, const Owner& texture, const ParamRow& row);

/// The end of the slider: the driver's maximum, or, if it has none, that of the reference renderer, which is
/// the row's.
[[nodiscard]] float maxAnisotropyOf(float driver, const ParamRow& row);

} // namespace texplorer::ui
