#include "texplorer/text/name_pattern.h"

#include "texplorer/text/printable.h"
#include "texplorer/text/utf8.h"

#include <algorithm>

namespace texplorer {

namespace {

constexpr std::size_t maxPartBytes = 100; // of the 255 bytes that file systems give a name

bool isPlain(std::string_view character) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-.,=@[]_";
    return character.size() == 1 ? plain.find(character) != std::string_view::npos
                                 : printable(character) == character;
}

} // namespace

std::string fileNamePart(std::string_view value) {
    std::string part;
    while (!value.empty()) {
        const std::size_t bytes = std::max<std::size_t>(1, firstCharacter(value).bytes);
        const std::string_view character = value.substr(0, bytes);
        const bool kept = isPlain(character) && !(part.empty() && character == ".");
        if (part.size() + (kept ? bytes : 1) > maxPartBytes)
            break;
        part += kept ? character : "_";
        value.remove_prefix(bytes);
    }
    return part.empty() ? "_" : part;
}

Result<NamePattern> NamePattern::parse(std::string_view text) {
    NamePattern pattern;
    std::string plain;
    const std::string_view whole = text;
    while (!text.empty()) {
        if (text.starts_with("{{") || text.starts_with("}}")) {
            plain += text.front();
            text.remove_prefix(2);
            continue;
        }
        if (text.front() != '{') {
            plain += text.front();
            text.remove_prefix(1);
            continue;
        }
        const std::size_t end = text.find('}');
        if (end == std::string_view::npos || end == 1)
            return fail(
                ErrorCode::Malformed,
                Sentence("expected a name and }} after each {{, found \"{0}\"; {{{{ is a brace", whole));
        if (!plain.empty())
            pattern.pieces_.push_back({std::exchange(plain, {}), false});
        pattern.pieces_.push_back({std::string(text.substr(1, end - 1)), true});
        text.remove_prefix(end + 1);
    }
    if (!plain.empty())
        pattern.pieces_.push_back({std::move(plain), false});
    return pattern;
}

std::vector<std::string> NamePattern::places() const {
    std::vector<std::string> names;
    for (const Piece& piece : pieces_) {
        if (piece.isPlace && std::ranges::find(names, piece.text) == names.end())
            names.push_back(piece.text);
    }
    return names;
}

std::string NamePattern::fill(const std::function<std::string(const std::string& place)>& valueOf) const {
    std::string name;
    for (const Piece& piece : pieces_)
        name += piece.isPlace ? fileNamePart(valueOf(piece.text)) : piece.text;
    return name;
}

} // namespace texplorer
