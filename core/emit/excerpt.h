#pragma once

// A program as somebody reads it who wants to know one thing: which of its lines that is.

#include "texplorer/emit/code.h"

#include <set>
#include <string>
#include <vector>

namespace texplorer::emit {

/// Whether a line is about one of these parameters, or about a part of it: "models[0].texCoords0" is also
/// what "models[0].texCoords0[2]" is.
[[nodiscard]] bool isAbout(const Line& line, const std::set<std::string, std::less<>>& paths);

/// Lines out of a program, each group with the heading that it stands below. Groups are apart by an empty
/// line; what all lines but headings are indented by is taken away.
struct Excerpt {
    std::vector<Line> lines;
    std::size_t left = 0; ///< lines that would be too many, as the fifth vertex of a shape
};

/// Of the lines that stand in the file those about these parameters, with the word on what they do, once; at
/// most `maxLines`, without headings.
[[nodiscard]] Excerpt excerptOf(const std::vector<Line>& program,
                                const std::set<std::string, std::less<>>& paths, std::size_t maxLines);

/// The same of calls and values that the program before it hasn't; nothing where there is none before it.
[[nodiscard]] Excerpt newIn(const std::vector<Line>& program, const std::vector<Line>& before,
                            std::size_t maxLines);

} // namespace texplorer::emit
