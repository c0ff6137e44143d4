#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// A token of a line of GLSL.
struct GlslToken {
    enum class Kind { Plain, Keyword, Uniform, Comment };
    Kind kind = Kind::Plain;
    std::string_view text;

    bool operator==(const GlslToken&) const = default;
};

using GlslNames = std::set<std::string, std::less<>>;

/// The names that a source declares as uniforms, one per line, as in the files of shaders/.
[[nodiscard]] GlslNames uniformsOf(std::string_view source);

/// Splits a line into tokens, which together are the line. Comments begin with //: the files have no others.
[[nodiscard]] std::vector<GlslToken> glslTokens(std::string_view line, const GlslNames& uniforms);

/// Splits a line into parts of at most `columns` bytes, which together are the line: broken after a blank or
/// an opening bracket. Parts after the first have `indent` columns less. A longer word is cut.
[[nodiscard]] std::vector<std::string_view> wrapLine(std::string_view line, std::size_t columns,
                                                     std::size_t indent);

/// The indentation of a line's parts after the first: one step more than the line, at most half of the
/// columns.
[[nodiscard]] std::size_t hangingIndent(std::string_view line, std::size_t columns);

/// Without the line ends.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

} // namespace texplorer::ui
