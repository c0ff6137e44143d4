#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// Its own, or what its shape is called in the window's language.
[[nodiscard]] std::string shownNameOf(const Model& model);

/// A list of the scene's models; there must be one.
void modelChoice(Session& session, float width);

} // namespace texplorer::ui
