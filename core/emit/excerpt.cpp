#include "texplorer/emit/excerpt.h"

#include <algorithm>
#include <optional>

namespace texplorer::emit {
namespace {

/// A word on the line below it.
bool isRemark(const Line& line) {
    const bool hasMore = std::ranges::any_of(line.parts, [](const Part& part) {
        return part.kind != Part::Kind::Comment && part.text.find_first_not_of(' ') != std::string::npos;
    });
    return !line.heading && !hasMore && textOf(line).find_first_not_of(' ') != std::string::npos;
}

/// Whether it makes a call, or has a value of the scene.
bool doesSomething(const Line& line) {
    return std::ranges::any_of(line.parts, [](const Part& part) {
        return part.kind == Part::Kind::Call || (part.kind != Part::Kind::Comment && !part.path.empty());
    });
}

std::size_t indentOf(const Line& line) {
    const std::string text = textOf(line);
    return std::min(text.find_first_not_of(' '), text.size());
}

void takeIndent(Line& line, std::size_t count) {
    for (Part& part : line.parts) {
        const std::size_t taken = std::min(count, part.text.size());
        part.text.erase(0, taken);
        count -= taken;
    }
}

/// Which one a line stands below; what stands outside of functions needs none.
std::optional<std::size_t> headingOf(const std::vector<Line>& lines, std::size_t line) {
    for (std::size_t i = line; lines[line].depth > 0 && i-- > 0;) {
        if (lines[i].heading)
            return i;
    }
    return {};
}

/// Which lines are about them.
std::vector<std::size_t> linesAbout(const std::vector<Line>& lines,
                                    const std::set<std::string, std::less<>>& paths) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (isAbout(lines[i], paths))
            found.push_back(i);
    }
    return found;
}

std::vector<std::string> textsOf(const std::vector<Line>& lines) {
    std::vector<std::string> texts;
    for (const Line& line : lines)
        texts.push_back(textOf(line));
    return texts;
}

/// Which of `texts` have no equal among `before`, in the order of both: those that are not in their longest
/// common subsequence, so that a call of the second unit is new though the first has the same.
std::vector<bool> areNew(const std::vector<std::string>& texts, const std::vector<std::string>& before) {
    const std::size_t columns = before.size() + 1;
    std::vector<std::uint16_t> longest((texts.size() + 1) * columns); // from a line of each to the end
    for (std::size_t i = texts.size(); i-- > 0;)
        for (std::size_t k = before.size(); k-- > 0;) {
            const std::size_t at = i * columns + k;
            longest[at] = texts[i] == before[k] ? static_cast<std::uint16_t>(longest[at + columns + 1] + 1)
                                                : std::max(longest[at + columns], longest[at + 1]);
        }
    std::vector<bool> found(texts.size(), true);
    for (std::size_t i = 0, k = 0; i < texts.size() && k < before.size();) {
        const std::size_t at = i * columns + k;
        if (texts[i] == before[k]) {
            found[i++] = false;
            ++k;
        } else if (longest[at + columns] >= longest[at + 1])
            ++i;
        else
            ++k;
    }
    return found;
}

std::vector<std::size_t> newLines(const std::vector<Line>& lines, const std::vector<Line>& before) {
    constexpr std::size_t maxLines = 2000; // of longer programs a line that stood anywhere is known
    const std::vector<std::string> texts = textsOf(lines);
    const std::vector<std::string> others = textsOf(shownLines(before, false));
    std::vector<bool> isNew;
    if (std::max(texts.size(), others.size()) <= maxLines)
        isNew = areNew(texts, others);
    else {
        const std::set<std::string> known(others.begin(), others.end());
        for (const std::string& text : texts)
            isNew.push_back(!known.contains(text));
    }
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (doesSomething(lines[i]) && isNew[i])
            found.push_back(i);
    }
    return found;
}

/// What a line is about, whichever of several vertices, levels or the like it is.
std::string subjectOf(const Line& line) {
    const auto named = std::ranges::find_if(
        line.parts, [](const Part& part) { return part.kind != Part::Kind::Comment && !part.path.empty(); });
    std::string subject = named == line.parts.end() ? std::string() : named->path;
    std::erase_if(subject, [](char c) { return c >= '0' && c <= '9'; });
    return subject;
}

/// Of lines one below the other about the same the first ones.
std::vector<std::size_t> withoutMoreOfTheSame(const std::vector<Line>& lines,
                                              const std::vector<std::size_t>& wanted) {
    constexpr std::size_t enough = 4; // the corners of a square
    std::vector<std::size_t> kept;
    std::size_t same = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const bool goesOn = i > 0 && wanted[i] == wanted[i - 1] + 1 && !subjectOf(lines[wanted[i]]).empty() &&
                            subjectOf(lines[wanted[i]]) == subjectOf(lines[wanted[i - 1]]);
        same = goesOn ? same + 1 : 1;
        if (same <= enough)
            kept.push_back(wanted[i]);
    }
    return kept;
}

Excerpt madeOf(const std::vector<Line>& lines, const std::vector<std::size_t>& all, std::size_t maxLines) {
    std::vector<std::size_t> wanted = withoutMoreOfTheSame(lines, all);
    wanted.resize(std::min(wanted.size(), maxLines));
    Excerpt excerpt;
    excerpt.left = all.size() - wanted.size();
    std::optional<std::size_t> heading;
    std::set<std::string> remarks;
    for (const std::size_t each : wanted) {
        const std::optional<std::size_t> above = headingOf(lines, each);
        if (heading != above && !excerpt.lines.empty())
            excerpt.lines.emplace_back();
        if (heading != above && above)
            excerpt.lines.push_back(lines[*above]);
        heading = above;
        if (each > 0 && isRemark(lines[each - 1]) && remarks.insert(textOf(lines[each - 1])).second)
            excerpt.lines.push_back(lines[each - 1]);
        excerpt.lines.push_back(lines[each]);
    }
    std::size_t common = std::string::npos;
    for (const Line& line : excerpt.lines) {
        if (!line.parts.empty() && !line.heading)
            common = std::min(common, indentOf(line));
    }
    for (Line& line : excerpt.lines)
        takeIndent(line, std::min(indentOf(line), common));
    return excerpt;
}

} // namespace

bool isAbout(const Line& line, const std::set<std::string, std::less<>>& paths) {
    return std::ranges::any_of(line.parts, [&](const Part& part) {
        if (part.path.empty() || part.kind == Part::Kind::Comment)
            return false;
        return std::ranges::any_of(paths, [&](const std::string& path) {
            return part.path.starts_with(path) &&
                   (part.path.size() == path.size() || part.path[path.size()] == '[' ||
                    part.path[path.size()] == '.');
        });
    });
}

Excerpt excerptOf(const std::vector<Line>& program, const std::set<std::string, std::less<>>& paths,
                  std::size_t maxLines) {
    const std::vector<Line> lines = shownLines(program, false);
    return madeOf(lines, linesAbout(lines, paths), maxLines);
}

Excerpt newIn(const std::vector<Line>& program, const std::vector<Line>& before, std::size_t maxLines) {
    const std::vector<Line> lines = shownLines(program, false);
    return before.empty() ? Excerpt{} : madeOf(lines, newLines(lines, before), maxLines);
}

} // namespace texplorer::emit
