#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Draws the equation of the selected unit's environment, and its input and output colours, for the probed
/// pixel or for reference colours: glColor and the mean of the image. Uses the previewed scene, if any.
void environmentLine(const Session& session);

} // namespace texplorer::ui
