#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// A list of the scene's models; there must be one.
void modelChoice(Session& session, float width);

} // namespace texplorer::ui
