#pragma once

#include "core/base/printable.h"

#include <string>
#include <string_view>

namespace texplorer {

/// A word as sh, bash, zsh and fish read it back: in single quotes where anything in it could mean something.
/// A backslash within them is one for all but fish, so that quotes and backslashes stand outside. zsh takes =
/// at a word's start for a program's place, fish % for a process.
///
/// It may be copied and pasted: characters that would steer a terminal, and bytes that are no UTF-8, are
/// printed by the shell, "$(printf '\033')", which fish reads from 3.4 on. $'\033' is for bash and zsh alone.
/// A shell drops line breaks at the end of what is printed, so that the character behind one is printed too,
/// and those at the word's end stay as they are.
[[nodiscard]] inline std::string shellWord(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos && !word.starts_with('=') &&
        !word.starts_with('%'))
        return std::string(word);
    constexpr std::string_view beginPrinted =
        "'\"$(printf\x20'"; // a space in it would make it a text to translate
    constexpr std::string_view endPrinted = "')\"'";
    const std::string_view body = word.substr(0, word.find_last_not_of('\n') + 1);
    const bool isPrintable = printable(body) == body;
    std::string text = "'";
    bool isPrinted = false; // by the shell
    for (std::size_t i = 0; i < body.size(); ++i) {
        const auto byte = static_cast<unsigned char>(body[i]);
        const bool goesOn = isPrinted && ((byte & 0xc0) == 0x80 || body[i - 1] == '\n');
        const bool isNext = goesOn || (!isPrintable && (byte < 0x20 || byte > 0x7e));
        if (isNext != isPrinted)
            text += isNext ? beginPrinted : endPrinted;
        isPrinted = isNext;
        if (isPrinted)
            text += {'\\', static_cast<char>('0' + (byte >> 6)), static_cast<char>('0' + (byte >> 3 & 7)),
                     static_cast<char>('0' + (byte & 7))};
        else if (body[i] == '\'' || body[i] == '\\')
            text += {'\'', '\\', body[i], '\''};
        else
            text += body[i];
    }
    if (isPrinted)
        text += endPrinted;
    return text.append(word.substr(body.size())) + "'";
}

} // namespace texplorer
