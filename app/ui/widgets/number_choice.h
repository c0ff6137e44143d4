#pragma once

#include <span>
#include <string>

namespace texplorer::ui {

/// One of what is chosen by its number.
struct NumberChoice {
    bool on;         ///< has a dot
    std::string tip; ///< its tooltip
};

/// A label and a button for each of `choices`, 0 and up, as wide as the room allows: `label`, or `shortLabel`
/// where that is too narrow. `name` is what tests call a button: "unit:2".
void numberChoice(const char* label, const char* shortLabel, const char* name,
                  std::span<const NumberChoice> choices, int& chosen);

} // namespace texplorer::ui
