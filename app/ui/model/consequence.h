#pragma once

#include "app/ui/model/session.h"

namespace texplorer::ui {

/// The effect of the settings on the explained pixel, in one sentence: "Minified 4×: linear in level 2".
/// Empty if no pixel is explained.
[[nodiscard]] Sentence consequenceOf(const Session& session);

/// The same for a texture unit.
[[nodiscard]] Sentence consequenceOf(const reference::UnitExplanation& unit);

/// The last edit, and whether it is saved.
[[nodiscard]] Sentence stateOf(const Document& document);

} // namespace texplorer::ui
