#include "texplorer/sheet/label_text.h"

#include "texplorer/text/utf8.h"

#include <algorithm>

namespace texplorer::sheet {
namespace {

constexpr std::string_view ellipsis = "…";
constexpr std::string_view breakers = " _,;-/";

/// Where each character begins, and the end; a byte that is no UTF-8 counts as one.
std::vector<std::size_t> charactersOf(std::string_view text) {
    std::vector<std::size_t> starts;
    for (std::size_t at = 0; at < text.size();
         at += std::max<std::size_t>(1, firstCharacter(text.substr(at)).bytes))
        starts.push_back(at);
    starts.push_back(text.size());
    return starts;
}

std::string_view withoutSpaces(std::string_view text) {
    while (text.ends_with(' '))
        text.remove_suffix(1);
    return text;
}

/// How much of the text stands in a line: up to the last place to break that fits; where none does, up to the
/// first. More than `room` then.
std::size_t lineEnd(std::string_view text, int room, const MeasureText& measure) {
    std::size_t end = 0;
    for (std::size_t at = text.find_first_of(breakers); at != std::string_view::npos;
         at = text.find_first_of(breakers, at + 1)) {
        if (end > 0 && measure(withoutSpaces(text.substr(0, at + 1))) > room)
            return end;
        end = at + 1;
    }
    return end == 0 || measure(text) <= room ? text.size() : end;
}

} // namespace

std::string shortenedMiddle(std::string_view text, int room, const MeasureText& measure) {
    if (measure(text) <= room)
        return std::string(text);
    const std::vector<std::size_t> starts = charactersOf(text);
    const std::size_t count = starts.size() - 1;
    const auto keeping = [&](std::size_t kept) {
        const std::size_t head = (kept + 1) / 2;
        return std::string(text.substr(0, starts[head]))
            .append(ellipsis)
            .append(text.substr(starts[count - (kept - head)]));
    };
    std::size_t fits = 0;
    std::size_t tooMany = count;
    while (fits + 1 < tooMany) { // the more are kept, the wider it is
        const std::size_t middle = fits + (tooMany - fits) / 2;
        (measure(keeping(middle)) <= room ? fits : tooMany) = middle;
    }
    return keeping(fits);
}

std::vector<std::string> labelLines(std::string_view text, int room, std::size_t maxLines,
                                    const MeasureText& measure) {
    std::vector<std::string> lines;
    while (!text.empty() && lines.size() < maxLines) {
        const std::size_t end = lines.size() + 1 == maxLines ? text.size() : lineEnd(text, room, measure);
        lines.push_back(shortenedMiddle(withoutSpaces(text.substr(0, end)), room, measure));
        text.remove_prefix(end);
        while (text.starts_with(' '))
            text.remove_prefix(1);
    }
    return lines;
}

} // namespace texplorer::sheet
