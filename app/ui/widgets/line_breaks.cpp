#include "app/ui/widgets/line_breaks.h"

#include "texplorer/text/utf8.h"

#include <algorithm>
#include <cstddef>

namespace texplorer::ui {
namespace {

/// The first character; invalid UTF-8 counts byte by byte.
Utf8Character characterAt(std::string_view text) {
    const Utf8Character first = firstCharacter(text);
    return first.bytes > 0 ? first : Utf8Character{static_cast<unsigned char>(text.front()), 1};
}

/// Full-width letters after which a line may break: ideographs, kana, hangul and their marks.
bool isIdeographic(char32_t letter) {
    return (letter >= 0x2E80 && letter <= 0xA4CF) || (letter >= 0xAC00 && letter <= 0xD7AF) ||
           (letter >= 0xF900 && letter <= 0xFAFF) || (letter >= 0xFE30 && letter <= 0xFE4F) ||
           (letter >= 0xFF00 && letter <= 0xFFEF) || (letter >= 0x20000 && letter <= 0x3FFFF);
}

constexpr std::u32string_view beginNoLine = U"，。、；：！？）》〉」』】〕”’％…—–·,.;:!?)]}%»×°";
constexpr std::u32string_view endNoLine = U"（《〈「『【〔“‘([{«";

bool isOneOf(char32_t letter, std::u32string_view letters) {
    return letters.find(letter) != std::u32string_view::npos;
}

/// Whether a line may break between two characters; the first may be a blank.
bool isBreak(char32_t before, char32_t after) {
    if (isOneOf(after, beginNoLine) || after == U' ')
        return false;
    return before == U' ' || ((isIdeographic(before) || isIdeographic(after)) && !isOneOf(before, endNoLine));
}

/// The number of bytes at the beginning that must stay together, including the blanks after them.
std::size_t pieceLength(std::string_view text) {
    Utf8Character before = characterAt(text);
    std::size_t end = before.bytes;
    while (end < text.size()) {
        const Utf8Character after = characterAt(text.substr(end));
        if (isBreak(before.character, after.character))
            break;
        before = after;
        end += after.bytes;
    }
    return end;
}

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t last = text.find_last_not_of(' ');
    return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// The number of bytes of a word that fit: at least one character.
std::size_t partThatFits(std::string_view word, float room, const TextMeasure& widthOf) {
    std::size_t end = characterAt(word).bytes;
    float width = widthOf(word.substr(0, end));
    while (end < word.size()) {
        const std::size_t next = characterAt(word.substr(end)).bytes;
        width += widthOf(word.substr(end, next));
        if (width > room)
            break;
        end += next;
    }
    return end;
}

void breakParagraph(std::vector<std::string_view>& lines, std::string_view text, float room,
                    const TextMeasure& widthOf) {
    std::size_t length = 0; // of the current line, the beginning of `text`
    float width = 0;
    const auto endLine = [&] {
        lines.push_back(withoutBlanks(text.substr(0, length)));
        text.remove_prefix(length);
        length = 0;
        width = 0;
    };
    while (length < text.size()) {
        const std::string_view piece = text.substr(length, pieceLength(text.substr(length)));
        const std::string_view word = withoutBlanks(piece);
        const float wordWidth = widthOf(word);
        if (width + wordWidth <= room) {
            width += wordWidth + (word.size() < piece.size() ? widthOf(piece.substr(word.size())) : 0);
            length += piece.size();
        } else if (length > 0) {
            endLine();
        } else {
            length = partThatFits(word, room, widthOf);
            if (length == word.size())
                length = piece.size();
            endLine();
        }
    }
    if (length > 0)
        endLine();
}

} // namespace

std::vector<std::string_view> linesOf(std::string_view text, float room, const TextMeasure& widthOf) {
    std::vector<std::string_view> lines;
    while (true) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view paragraph = text.substr(0, end);
        if (withoutBlanks(paragraph).empty())
            lines.push_back(paragraph.substr(0, 0));
        else
            breakParagraph(lines, paragraph, room, widthOf);
        if (end == text.size())
            return lines;
        text.remove_prefix(end + 1);
    }
}

float widestPiece(std::string_view text, const TextMeasure& widthOf) {
    float widest = 0;
    while (!text.empty()) {
        const std::string_view piece = text.substr(0, pieceLength(text));
        widest = std::max(widest, widthOf(withoutBlanks(piece)));
        text.remove_prefix(piece.size());
    }
    return widest;
}

} // namespace texplorer::ui
