#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

void combineSection(const Session& session); ///< of the selected unit, whose mode is GL_COMBINE

} // namespace texplorer::ui
