#pragma once

#include <span>
#include <string>

namespace texplorer::ui {

/// One of what is chosen by its number.
struct NumberChoice {
    bool on;         ///< has a dot
    std::string tip; ///< its tooltip
};

/// A label and a button for each of `choices`, 0 and up: `shortWords` where the room is too narrow for
/// `words`, and the buttons below it where they wouldn't fit beside it. `name` is what tests call a button:
/// "unit:2".
void numberChoice(const char* words, const char* shortWords, const char* name,
                  std::span<const NumberChoice> choices, int& chosen);

} // namespace texplorer::ui
