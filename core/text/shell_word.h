#pragma once

#include "texplorer/text/printable.h"

#include <string>
#include <string_view>

namespace texplorer {

/// Quotes a word for sh, bash, zsh and fish: in single quotes if any character is special. In fish, a
/// backslash in single quotes escapes; so quotes and backslashes are put outside. A leading = (zsh) or %
/// (fish) is quoted, too.
///
/// The result is safe to copy and paste: control characters and invalid UTF-8 are printed by the shell,
/// "$(printf '\033')", which fish supports from 3.4 on ($'\033' works only in bash and zsh). Shells drop line
/// breaks at the end of printed text, so the character after a line break is printed with it; line breaks at
/// the end of the word are kept as they are.
[[nodiscard]] inline std::string shellWord(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos && !word.starts_with('=') &&
        !word.starts_with('%'))
        return std::string(word);
    constexpr std::string_view beginPrinted =
        "'\"$(printf\x20'"; // \x20: with a plain space, this would count as a text to translate
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
