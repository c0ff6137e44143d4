#include "texplorer/emit/code.h"

#include <algorithm>

namespace texplorer::emit {
namespace {

constexpr std::string_view indent = "    ";
constexpr std::size_t minColumns = 16;

/// The last place before `columns` at which a text may be broken, where what goes on has no leading space; 0:
/// none.
std::size_t breakOf(std::string_view text, std::size_t columns) {
    std::size_t outside = 0;
    std::size_t inside = 0;
    int depth = 0;
    for (std::size_t i = 0; i < std::min(columns, text.size()); ++i) {
        depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
        const bool gap = i + 1 < text.size() && text[i + 1] == ' ';
        if (text[i] == ',' && gap && depth > 0)
            inside = i + 2;
        else if ((text[i] == ',' || text[i] == ';' || text[i] == '=') && gap)
            outside = i + 2;
        else if (text[i] == '(' && outside == 0)
            outside = i + 1;
    }
    return outside > 0 ? outside : inside;
}

/// Of a comment: after a word.
std::size_t wordBreakOf(std::string_view text, std::size_t columns) {
    const std::size_t space = text.substr(0, std::min(columns + 1, text.size())).rfind(' ');
    return space == std::string_view::npos || text.find_first_not_of(' ') > space ? 0 : space + 1;
}

/// Takes the first `count` characters of the parts away and gives them.
std::vector<Part> takeFront(std::vector<Part>& parts, std::size_t count) {
    std::vector<Part> front;
    while (count > 0 && !parts.empty()) {
        Part& first = parts.front();
        Part taken = first;
        taken.text = first.text.substr(0, count);
        count -= taken.text.size();
        first.text.erase(0, taken.text.size());
        front.push_back(std::move(taken));
        if (first.text.empty())
            parts.erase(parts.begin());
    }
    while (!front.empty() && front.back().text.ends_with(' '))
        front.back().text.pop_back();
    return front;
}

} // namespace

std::string textOf(const Line& line) {
    std::string text;
    for (const Part& part : line.parts)
        text += part.text;
    return text;
}

bool mentions(const Line& line, std::string_view path) {
    return !path.empty() &&
           std::ranges::any_of(line.parts, [&](const Part& part) { return part.path == path; });
}

std::vector<Line> shownLines(const std::vector<Line>& lines, bool all) {
    std::vector<Line> shown;
    int depth = 0;
    bool isApart = true;
    for (const Line& line : lines) {
        if (!all && !line.needed)
            continue;
        if (line.heading && !isApart && line.depth <= depth)
            shown.emplace_back();
        depth = line.depth;
        isApart = textOf(line).empty();
        shown.push_back(line);
    }
    return shown;
}

std::string textOf(const std::vector<Line>& lines, bool all) {
    std::string text;
    for (const Line& line : shownLines(lines, all)) {
        if (!line.data) {
            text += textOf(line) + "\n";
            continue;
        }
        const std::string shown = textOf(line);
        text += shown.substr(0, shown.find('{') + 1) + "\n";
        text += line.data->text() + "};\n";
    }
    return text;
}

bool readsAs(const Line& line, const Line& other) {
    return line.needed == other.needed && line.heading == other.heading && line.depth == other.depth &&
           textOf(line) == textOf(other) &&
           (line.data == other.data || (line.data && other.data && *line.data == *other.data));
}

std::vector<std::vector<Part>> wrapped(const Line& line, std::size_t columns) {
    columns = std::max(columns, minColumns);
    const std::string whole = textOf(line);
    const std::string margin(std::min(whole.find_first_not_of(' '), whole.size()), ' ');
    std::vector<std::vector<Part>> rows;
    std::vector<Part> rest = line.parts;
    std::string text = whole;
    std::string prefix; // of the row that is made
    while (prefix.size() + text.size() > columns) {
        const std::size_t room = columns - std::min(prefix.size(), columns - 1);
        const std::size_t skipped = std::min(text.find_first_not_of(' '), text.size());
        const bool isComment =
            text.compare(skipped, 2, "/*") == 0 || rest.front().kind == Part::Kind::Comment;
        const std::size_t cut = isComment ? wordBreakOf(text, room) : breakOf(text, room);
        if (cut <= skipped || cut >= text.size())
            break;
        rows.push_back(takeFront(rest, cut));
        rows.back().insert(rows.back().begin(), Part{Part::Kind::Plain, prefix});
        text.erase(0, cut);
        prefix = margin + std::string(indent);
    }
    rows.push_back(std::move(rest));
    rows.back().insert(rows.back().begin(), Part{Part::Kind::Plain, prefix});
    for (std::vector<Part>& row : rows)
        std::erase_if(row, [](const Part& part) { return part.text.empty(); });
    return rows;
}

} // namespace texplorer::emit
