#include "texplorer/text/printable.h"

#include "texplorer/text/utf8.h"

#include <algorithm>
#include <array>

namespace texplorer {

namespace {

struct Range {
    char32_t first;
    char32_t last;
};

constexpr std::array steering{
    Range{0x00, 0x1F},     // C0
    Range{0x7F, 0x9F},     // DEL, C1
    Range{0x061C, 0x061C}, // Arabic letter mark
    Range{0x200E, 0x200F}, // left-to-right and right-to-left marks
    Range{0x2028, 0x202E}, // line and paragraph separators, embeddings and overrides
    Range{0x2066, 0x2069}, // isolates
};

bool steers(char32_t character, LineBreaks lines) {
    if (lines == LineBreaks::Keep && (character == U'\n' || character == U'\t'))
        return false;
    return std::ranges::any_of(
        steering, [=](const Range& each) { return character >= each.first && character <= each.last; });
}

} // namespace

std::string printable(std::string_view text, LineBreaks lines) {
    constexpr char hexDigits[] = "0123456789abcdef";
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const Utf8Character next = firstCharacter(text);
        if (next.bytes == 0) {
            shown += "\xEF\xBF\xBD"; // U+FFFD
            text.remove_prefix(1);
            continue;
        }
        if (steers(next.character, lines)) {
            shown += "\\u";
            for (int shift = 12; shift >= 0; shift -= 4)
                shown += hexDigits[next.character >> shift & 15];
        } else {
            shown += text.substr(0, next.bytes);
        }
        text.remove_prefix(next.bytes);
    }
    return shown;
}

} // namespace texplorer
