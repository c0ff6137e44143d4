#pragma once

#include <string>
#include <string_view>

namespace texplorer {

/// A word as a shell reads it back.
[[nodiscard]] inline std::string shellWord(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    std::string text = "'";
    for (const char each : word)
        text += each == '\'' ? std::string("'\\''") : std::string(1, each);
    return text + "'";
}

} // namespace texplorer
