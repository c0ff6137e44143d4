#pragma once

#include "core/base/printable.h"

#include <string>
#include <string_view>

namespace texplorer {

/// A word as sh, bash, zsh and fish read it back: in single quotes where anything in it could mean something.
/// A backslash within them is one for all but fish, so that quotes and backslashes stand outside. zsh takes =
/// at a word's start for a program's place, fish % for a process.
///
/// One with characters that would steer a terminal, or with bytes that are no UTF-8, has them as octal
/// numbers,
/// $'\033', which bash, zsh and ksh read (POSIX 2024, 2.2.4): it may be copied and pasted.
[[nodiscard]] inline std::string shellWord(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos && !word.starts_with('=') &&
        !word.starts_with('%'))
        return std::string(word);
    const bool isPrintable = printable(word) == word;
    std::string text = isPrintable ? "'" : "$'";
    for (const char each : word) {
        const auto byte = static_cast<unsigned char>(each);
        const bool isSpecial = each == '\'' || each == '\\';
        if (isPrintable)
            text += isSpecial ? std::string("'\\") + each + "'" : std::string(1, each);
        else if (byte < 0x20 || byte > 0x7e)
            text += {'\\', static_cast<char>('0' + (byte >> 6)), static_cast<char>('0' + (byte >> 3 & 7)),
                     static_cast<char>('0' + (byte & 7))};
        else
            text += isSpecial ? std::string{'\\', each} : std::string(1, each);
    }
    return text + "'";
}

} // namespace texplorer
