#pragma once

#include <optional>
#include <span>
#include <string>

namespace texplorer::ui {

/// A choice by its number.
struct NumberChoice {
    bool on;         ///< is marked with a dot
    std::string tip; ///< its tooltip
};

/// A label and a button for each of `choices`, from 0: with `shortWords` if the room is too narrow for
/// `words`, and with the buttons below the label if they do not fit next to it. `name` is the name of a
/// button in tests: "unit:2". Returns the number that was pressed.
[[nodiscard]] std::optional<int> numberChoice(const char* words, const char* shortWords, const char* name,
                                              std::span<const NumberChoice> choices, int chosen);

} // namespace texplorer::ui
