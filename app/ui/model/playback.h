#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// Advances the clock by `seconds` of real time, if it plays and something depends on it.
void advance(Session& session, double seconds);

/// Whether the next frame differs even without input.
[[nodiscard]] bool isMoving(const Session& session);

} // namespace texplorer::ui
