#include "texplorer/text/utf8.h"

#include <array>
#include <cstdint>

namespace texplorer {

//   bytes   bits     first      the others
//   1        7       0xxxxxxx
//   2       11       110xxxxx   10xxxxxx
//   3       16       1110xxxx   10xxxxxx
//   4       21       11110xxx   10xxxxxx
Utf8Character firstCharacter(std::string_view text) {
    if (text.empty())
        return {};
    const auto byte = [&](std::size_t i) -> std::uint32_t { return static_cast<unsigned char>(text[i]); };
    const std::uint32_t first = byte(0);
    if (first < 0x80)
        return {first, 1};
    const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || size > text.size())
        return {};
    char32_t character = first & (0xFFU >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0) != 0x80)
            return {};
        character = character << 6 | (byte(i) & 0x3F);
    }
    constexpr std::array<char32_t, 5> min{0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
    if (character < min[size] || character > 0x10FFFF || surrogate)
        return {};
    return {character, size};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = firstCharacter(text).bytes;
        if (bytes == 0)
            return false;
        text.remove_prefix(bytes);
    }
    return true;
}

} // namespace texplorer
