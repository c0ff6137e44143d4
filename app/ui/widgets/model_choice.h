#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// Its own, or what its shape is called in the window's language.
[[nodiscard]] std::string shownNameOf(const Model& model);

/// A list of the scene's models, of which there must be one: as wide as the name of the chosen one, at least
/// and at most so wide.
void modelChoice(Session& session, float least, float most);

} // namespace texplorer::ui
