#pragma once

#include "core/base/printable.h"

#include <string>
#include <string_view>

namespace texplorer {

/// A word as a shell reads it back. One with characters that would steer a terminal, or with bytes that are
/// no UTF-8, has them as octal numbers, $'\033', which bash, zsh and ksh read (POSIX 2024, 2.2.4): it may be
/// copied and pasted.
[[nodiscard]] inline std::string shellWord(const std::string& word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
        return word;
    const bool isPrintable = printable(word) == word;
    std::string text = isPrintable ? "'" : "$'";
    for (const char each : word) {
        const auto byte = static_cast<unsigned char>(each);
        if (isPrintable)
            text += each == '\'' ? std::string("'\\''") : std::string(1, each);
        else if (byte < 0x20 || byte > 0x7e)
            text += {'\\', static_cast<char>('0' + (byte >> 6)), static_cast<char>('0' + (byte >> 3 & 7)),
                     static_cast<char>('0' + (byte & 7))};
        else
            text += each == '\'' || each == '\\' ? std::string{'\\', each} : std::string(1, each);
    }
    return text + "'";
}

} // namespace texplorer
