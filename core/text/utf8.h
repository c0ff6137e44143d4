#pragma once

#include <cstddef>
#include <string_view>

namespace texplorer {

struct Utf8Character {
    char32_t character = 0;
    std::size_t bytes = 0; ///< 0: the text does not begin with a character
};

/// Returns the first character of a text if it is well-formed UTF-8 (RFC 3629: no overlong forms, no
/// surrogates, nothing above U+10FFFF).
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Whether the whole text is well-formed UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace texplorer
