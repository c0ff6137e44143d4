#include "texplorer/text/json_encoding.h"

#include <algorithm>
#include <array>

namespace texplorer {
namespace {

/// What a text begins with: a mark, or zeros next to the ASCII characters that JSON begins with.
struct Start {
    std::string_view bytes; ///< '.': any but zero
    const char* encoding;
};

constexpr std::array starts{Start{{"\xFF\xFE\0\0", 4}, "UTF-32"}, Start{{"\0\0\xFE\xFF", 4}, "UTF-32"},
                            Start{"\xFF\xFE", "UTF-16"},          Start{"\xFE\xFF", "UTF-16"},
                            Start{{".\0\0\0", 4}, "UTF-32"},      Start{{"\0\0\0.", 4}, "UTF-32"},
                            Start{{".\0.\0", 4}, "UTF-16"},       Start{{"\0.\0.", 4}, "UTF-16"}};

bool beginsSo(std::string_view text, const Start& start) {
    return text.size() >= start.bytes.size() &&
           std::ranges::equal(start.bytes, text.substr(0, start.bytes.size()), [](char wanted, char found) {
               return wanted == '.' ? found != 0 : found == wanted;
           });
}

} // namespace

Result<void> checkEncoding(std::string_view json) {
    const auto* other =
        std::ranges::find_if(starts, [json](const Start& each) { return beginsSo(json, each); });
    if (other != starts.end())
        return fail(ErrorCode::Malformed, Sentence("expected UTF-8, found {0}", ProperName{other->encoding}));
    const std::size_t at = json.find('\0');
    if (at == std::string_view::npos)
        return {};
    return fail(ErrorCode::Malformed, "expected JSON, found a NUL character", atCharacter(json, at));
}

std::string pointerStep(std::string_view key) {
    std::string text;
    for (const char c : key)
        text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

Location atCharacter(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte);
    const std::size_t begin = before.rfind('\n') + 1; // 0 where there is none
    std::string_view line = before.substr(begin);
    if (begin == 0 && line.starts_with(byteOrderMark))
        line.remove_prefix(byteOrderMark.size());
    const auto isFirstByte = [](char each) { return (static_cast<unsigned char>(each) & 0xC0U) != 0x80U; };
    return atLine(1 + static_cast<std::size_t>(std::ranges::count(before, '\n')),
                  1 + static_cast<std::size_t>(std::ranges::count_if(line, isFirstByte)));
}

} // namespace texplorer
