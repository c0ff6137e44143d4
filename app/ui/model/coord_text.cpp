#include "app/ui/model/coord_text.h"

#include "app/ui/model/tex_coord_edits.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>

namespace texplorer::ui {
namespace {

constexpr std::string_view between = " \t\r,;()[]";
constexpr std::size_t maxWordLength = 40;                   // of what a message repeats
constexpr std::size_t maxTextLength = std::size_t{8} << 20; // more than the coordinates of any model take

Result<float> numberOf(std::string_view word, std::size_t line) {
    std::istringstream stream{std::string(word)};
    stream.imbue(std::locale::classic());
    double value = 0;
    if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof() ||
        !std::isfinite(value))
        return fail(ErrorCode::Malformed, Sentence("line {0}: expected a number, found \"{1}\"", line,
                                                   ProperName{printable(word.substr(0, maxWordLength))}));
    if (value < double{coordRange.min} || value > double{coordRange.max})
        return fail(ErrorCode::OutOfRange, Sentence("line {0}: expected a number from {1} to {2}, found {3}",
                                                    line, coordRange.min, coordRange.max, value));
    return static_cast<float>(value);
}

/// Nothing where the line is empty.
Result<std::optional<glm::vec4>> coordOf(std::string_view text, std::size_t line) {
    glm::vec4 coord(0, 0, 0, 1);
    int count = 0;
    while (true) {
        const std::size_t begin = text.find_first_not_of(between);
        if (begin == std::string_view::npos)
            break;
        text.remove_prefix(begin);
        const std::string_view word = text.substr(0, text.find_first_of(between));
        const Result<float> number = numberOf(word, line);
        if (!number)
            return fail(number.error());
        if (count < 4)
            coord[count] = *number;
        ++count;
        text.remove_prefix(word.size());
    }
    if (count == 0)
        return std::nullopt;
    if (count < 2 || count > 4)
        return fail(ErrorCode::Malformed,
                    Sentence("line {0}: expected 2 to 4 numbers, found {1}", line, count));
    return coord;
}

} // namespace

std::string coordText(std::span<const glm::vec4> coords) {
    std::string text;
    for (const glm::vec4& each : coords) {
        text += each.z == 0 && each.w == 1 ? fmt::format("{} {}\n", each.x, each.y)
                                           : fmt::format("{} {} {} {}\n", each.x, each.y, each.z, each.w);
    }
    return text;
}

Result<TexCoords> parseCoordText(std::string_view text) {
    if (text.size() > maxTextLength)
        return fail(ErrorCode::TooLarge,
                    Sentence("expected at most {0} letters, found {1}", maxTextLength, text.size()));
    TexCoords coords;
    std::size_t line = 0;
    while (!text.empty()) {
        ++line;
        const std::size_t end = text.find('\n');
        const Result<std::optional<glm::vec4>> coord = coordOf(text.substr(0, end), line);
        if (!coord)
            return fail(coord.error());
        if (*coord)
            coords.push_back(**coord);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (coords.empty())
        return fail(ErrorCode::Malformed, "expected lines with two numbers each, found none");
    return coords;
}

} // namespace texplorer::ui
