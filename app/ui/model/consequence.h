#pragma once

#include "app/ui/model/session.h"

#include <string>

namespace texplorer::ui {

/// What the settings do to the pixel that is explained, in one sentence: "Minified 4×: linear in level 2".
/// Empty where none is explained.
[[nodiscard]] std::string consequenceOf(const Session& session);

/// The same of a texture unit.
[[nodiscard]] std::string consequenceOf(const reference::UnitExplanation& unit);

/// What was edited last, and whether it is saved.
[[nodiscard]] std::string stateOf(const Document& document);

} // namespace texplorer::ui
