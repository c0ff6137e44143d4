#include "texplorer/mesh/obj_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

namespace texplorer {
namespace {

constexpr std::string_view spaces = " \t\f\v\r";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(spaces);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(spaces) + 1 - first);
}

std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        words.push_back(text.substr(0, text.find_first_of(spaces)));
        text.remove_prefix(words.back().size());
    }
    return words;
}

/// At most so much of what a file holds is repeated in a sentence.
std::string quoted(std::string_view word) {
    constexpr std::size_t most = 24;
    return fmt::format("\"{}{}\"", word.substr(0, most), word.size() > most ? "…" : "");
}

template<class Number>
bool isNumber(std::string_view word, Number& number) {
    if (word.starts_with('+'))
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size();
}

/// "v", "v/vt", "v//vn" or "v/vt/vn", of whole numbers other than 0.
bool isCorner(std::string_view word) {
    for (int part = 0; part < 3; ++part) {
        const std::size_t slash = word.find('/');
        const std::string_view number = word.substr(0, slash);
        const bool mayLack = part == 1 && slash != std::string_view::npos;
        if (int index = 0; !(mayLack && number.empty()) && (!isNumber(number, index) || index == 0))
            return false;
        if (slash == std::string_view::npos)
            return true;
        word.remove_prefix(slash + 1);
    }
    return false;
}

class LineReader {
public:
    explicit LineReader(std::string_view text)
        : rest_(text) {
        constexpr std::string_view mark = "\xEF\xBB\xBF";
        if (rest_.starts_with(mark))
            rest_.remove_prefix(mark.size());
    }

    /// The next line with those that continue it; false at the end.
    bool next(std::string& line) {
        line.clear();
        number_ += continued_;
        continued_ = 0;
        if (rest_.empty())
            return false;
        do {
            const std::size_t end = rest_.find('\n');
            std::string_view part = trimmed(rest_.substr(0, end));
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
            ++continued_;
            const bool goesOn = part.ends_with('\\') && !rest_.empty();
            if (goesOn)
                part.remove_suffix(1);
            line.append(line.empty() ? "" : " ").append(part);
            if (!goesOn)
                break;
        } while (true);
        return true;
    }
    /// From 1: of the first of the joined lines.
    [[nodiscard]] int number() const { return number_ + 1; }

private:
    std::string_view rest_;
    int number_ = 0;
    int continued_ = 0;
};

tl::unexpected<Error> malformed(int line, Sentence what) {
    return fail(ErrorCode::Malformed, Sentence("line {0}: {1}", line, std::move(what)));
}

Result<void> checkMost(int line, const Sentence& what, std::size_t most, std::size_t found) {
    if (found <= most)
        return {};
    return fail(ErrorCode::TooLarge,
                Sentence("line {0}: {1}: at most {2} are read, found {3}", line, what, most, found));
}

Result<void> takeNumbers(int line, std::span<const std::string_view> words, std::size_t least,
                         std::size_t most, ObjLines& lines) {
    if (words.size() < least + 1)
        return malformed(line, Sentence("expected {0} numbers after {1}, found {2}", least,
                                        ProperName{words.front()}, words.size() - 1));
    for (const std::string_view word : words.subspan(1)) {
        if (float number = 0; !isNumber(word, number) || !std::isfinite(number))
            return malformed(line, Sentence("expected a finite number, found {0}", ProperName{quoted(word)}));
    }
    for (const std::string_view word : words.first(std::min(words.size(), most + 1)))
        lines.text.append(word).append(" ");
    lines.text += '\n';
    return checkMost(line, N_("lines of v, vt and vn"), maxObjNumbers, ++lines.numbers);
}

Result<void> takePolygon(int line, std::span<const std::string_view> words, ObjLines& lines) {
    if (words.size() < 4)
        return malformed(line,
                         Sentence("expected a polygon of at least 3 vertices, found {0}", words.size() - 1));
    for (const std::string_view word : words.subspan(1)) {
        if (!isCorner(word))
            return malformed(
                line, Sentence("expected v, v/vt, v//vn or v/vt/vn, found {0}", ProperName{quoted(word)}));
    }
    for (const std::string_view word : words)
        lines.text.append(word).append(" ");
    lines.text += '\n';
    lines.polygonLines.push_back(line);
    lines.triangles += words.size() - 3; // f and the fan's first two corners
    return checkMost(line, N_("triangles"), maxObjTriangles, lines.triangles);
}

Result<void> takeLine(int number, const std::string& line, ObjLines& lines) {
    const std::string_view keyword = std::string_view(line).substr(0, line.find_first_of(spaces));
    const bool hasNumbers = keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f";
    if (hasNumbers) {
        const std::vector<std::string_view> words = wordsOf(std::string_view(line).substr(0, line.find('#')));
        if (keyword == "f")
            return takePolygon(number, words, lines);
        return keyword == "vt" ? takeNumbers(number, words, 1, 2, lines)
                               : takeNumbers(number, words, 3, 3, lines);
    }
    const std::string name(trimmed(std::string_view(line).substr(keyword.size())));
    if (keyword == "mtllib" && !name.empty() &&
        std::ranges::find(lines.libraries, name) == lines.libraries.end())
        lines.libraries.push_back(name);
    if (keyword != "o" && keyword != "g" && keyword != "usemtl")
        return {};
    lines.text.append(line).append("\n");
    if (Result<void> fits = checkMost(number, N_("bytes of a name"), maxObjNameBytes, name.size()); !fits)
        return fits;
    return checkMost(number, N_("objects, groups and uses of materials"), maxObjNames, ++lines.names);
}

} // namespace

bool beginsAsObj(ByteView file) {
    constexpr std::array<std::string_view, 9> words{"v", "vt", "vn", "f", "o", "g", "s", "mtllib", "usemtl"};
    constexpr std::size_t most = 4096;
    std::string_view text(reinterpret_cast<const char*>(file.data()), std::min(file.size(), most));
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::vector<std::string_view> line = wordsOf(text.substr(0, end));
        if (!line.empty() && !line.front().starts_with('#'))
            return std::ranges::find(words, line.front()) != words.end();
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return false;
}

Result<ObjLines> checkedObjLines(ByteView file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    ObjLines lines;
    LineReader reader(text);
    for (std::string line; reader.next(line);) {
        const auto isControl = [](char each) {
            return static_cast<unsigned char>(each) < ' ' && each != '\t';
        };
        if (Result<void> fits =
                checkMost(reader.number(), N_("bytes of a line"), maxObjLineBytes, line.size());
            !fits)
            return fail(fits.error());
        if (const auto found = std::ranges::find_if(line, isControl); found != line.end())
            return malformed(reader.number(),
                             Sentence("expected text, found the byte {0}", static_cast<int>(*found)));
        if (line.empty() || line.starts_with('#'))
            continue;
        if (Result<void> taken = takeLine(reader.number(), line, lines); !taken)
            return fail(taken.error());
        constexpr std::size_t maxLibraries = 16;
        if (lines.libraries.size() > maxLibraries)
            return malformed(reader.number(),
                             Sentence("expected at most {0} material libraries", maxLibraries));
    }
    return lines;
}

} // namespace texplorer
