#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The chosen model: which one, how many there are and in which order, and what the tables have of it.
void modelSection(Session& session);

} // namespace texplorer::ui
