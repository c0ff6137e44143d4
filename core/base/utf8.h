#pragma once

#include <cstddef>
#include <string_view>

namespace texplorer {

struct Utf8Character {
    char32_t character = 0;
    std::size_t bytes = 0; ///< 0: the text doesn't begin with one
};

/// The first character of a text, if it is well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates,
/// nothing above U+10FFFF).
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Whether all of it is.
[[nodiscard]] bool isUtf8(std::string_view text);

} // namespace texplorer
