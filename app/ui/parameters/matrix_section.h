#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The steps of the selected unit's texture matrix.
void matrixSection(const Session& session);

/// A button for each operation, which adds a step: `perLine` buttons per line.
void addStepButtons(const Session& session, int perLine);

/// The presets that move the texture, one click each, and a button that adds a step.
void motionButtons(const Session& session);

} // namespace texplorer::ui
