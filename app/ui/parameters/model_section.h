#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The selected model: the choice, number and order of models, and its rows of the tables.
void modelSection(const Session& session);

} // namespace texplorer::ui
