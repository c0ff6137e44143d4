#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::ui {

/// A stretch of one line of GLSL.
struct GlslToken {
    enum class Kind { Plain, Keyword, Uniform, Comment };
    Kind kind = Kind::Plain;
    std::string_view text;

    bool operator==(const GlslToken&) const = default;
};

using GlslNames = std::set<std::string, std::less<>>;

/// The names that a source declares as uniforms, one a line, as the files of shaders/ do.
[[nodiscard]] GlslNames uniformsOf(std::string_view source);

/// A line in stretches of one kind, which together are the line. Comments begin with //: the files have no
/// others.
[[nodiscard]] std::vector<GlslToken> glslTokens(std::string_view line, const GlslNames& uniforms);

/// Without the line ends.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

} // namespace texplorer::ui
