#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// The model's own name, or the name of its shape in the window's language.
[[nodiscard]] std::string shownNameOf(const Model& model);

/// A list of the scene's models, of which there must be at least one: as wide as the name of the selected
/// one, within the given limits.
void modelChoice(const Session& session, float minWidth, float maxWidth);

} // namespace texplorer::ui
