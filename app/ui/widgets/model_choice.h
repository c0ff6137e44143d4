#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The model's own name, which is not translated, or the name of its shape.
[[nodiscard]] Sentence shownNameOf(const Model& model);

/// A list of the scene's models, of which there must be at least one: as wide as the name of the selected
/// one, within the given limits.
void modelChoice(const Session& session, float minWidth, float maxWidth);

} // namespace texplorer::ui
