#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// The effect of the settings on the explained pixel, in one sentence: "Minified 4×: linear in level 2".
/// Empty if no pixel is explained.
[[nodiscard]] std::string consequenceOf(const Session& session);

/// The same for a texture unit.
[[nodiscard]] std::string consequenceOf(const reference::UnitExplanation& unit);

/// The last edit, and whether it is saved.
[[nodiscard]] std::string stateOf(const Document& document);

} // namespace texplorer::ui
