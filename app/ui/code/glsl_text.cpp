#include "app/ui/code/glsl_text.h"

#include <algorithm>
#include <array>
#include <cctype>

using namespace std::string_view_literals;

namespace texplorer::ui {
namespace {

/// Keywords of GLSL 3.30 and GLSL ES 3.00 that the shaders use, in the order of std::string_view's <.
constexpr std::array keywords{
    "#define"sv, "#version"sv,  "bool"sv,      "bvec2"sv,     "bvec3"sv,         "bvec4"sv,  "const"sv,
    "core"sv,    "discard"sv,   "else"sv,      "false"sv,     "flat"sv,          "float"sv,  "for"sv,
    "highp"sv,   "if"sv,        "in"sv,        "inout"sv,     "int"sv,           "ivec2"sv,  "ivec3"sv,
    "ivec4"sv,   "layout"sv,    "mat3"sv,      "mat4"sv,      "noperspective"sv, "out"sv,    "precision"sv,
    "return"sv,  "sampler1D"sv, "sampler2D"sv, "sampler3D"sv, "samplerCube"sv,   "smooth"sv, "true"sv,
    "uniform"sv, "vec2"sv,      "vec3"sv,      "vec4"sv,      "void"sv,          "while"sv};
static_assert(std::ranges::is_sorted(keywords));

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t wordEnd(std::string_view line, std::size_t at) {
    ++at; // a # belongs to its word
    while (at < line.size() && isWordCharacter(line[at]))
        ++at;
    return at;
}

} // namespace

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

std::vector<std::string_view> wrapLine(std::string_view line, std::size_t columns, std::size_t indent) {
    std::vector<std::string_view> parts;
    std::size_t room = std::max<std::size_t>(columns, 1);
    const std::size_t later = room - std::min(indent, room - 1);
    const std::size_t begin =
        std::min(line.find_first_not_of(' '), line.size()); // no break in the indentation
    while (line.size() > room) {
        std::size_t end = room;
        while (end > 0 && std::string_view(" (").find(line[end - 1]) == std::string_view::npos)
            --end;
        if (end <= (parts.empty() ? begin : 0)) { // a word that is too long
            end = room;
            while (end > 1 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U)
                --end; // within a character of UTF-8
        }
        parts.push_back(line.substr(0, end));
        line.remove_prefix(end);
        room = later;
    }
    if (!line.empty() || parts.empty())
        parts.push_back(line);
    return parts;
}

std::size_t hangingIndent(std::string_view line, std::size_t columns) {
    constexpr std::size_t step = 4;
    return std::min(std::min(line.find_first_not_of(' '), line.size()) + step, columns / 2);
}

std::vector<GlslToken> glslTokens(std::string_view line, const GlslNames& uniforms) {
    using Kind = GlslToken::Kind;
    std::vector<GlslToken> tokens;
    const auto add = [&](Kind kind, std::string_view text) {
        if (!tokens.empty() && tokens.back().kind == kind) // they are adjacent in the line
            tokens.back().text = {tokens.back().text.data(), tokens.back().text.size() + text.size()};
        else if (!text.empty())
            tokens.push_back({kind, text});
    };
    std::size_t at = 0;
    while (at < line.size()) {
        if (line.substr(at).starts_with("//")) {
            add(Kind::Comment, line.substr(at));
            break;
        }
        const bool isWord = isWordCharacter(line[at]) || line[at] == '#';
        const std::size_t end = isWord ? wordEnd(line, at) : at + 1;
        const std::string_view word = line.substr(at, end - at);
        add(!isWord                                      ? Kind::Plain
            : std::ranges::binary_search(keywords, word) ? Kind::Keyword
            : uniforms.find(word) != uniforms.end()      ? Kind::Uniform
                                                         : Kind::Plain,
            word);
        at = end;
    }
    return tokens;
}

GlslNames uniformsOf(std::string_view source) {
    GlslNames names;
    for (std::string_view line : linesOf(source)) {
        line = line.substr(0, line.find("//"));
        const std::size_t end = line.find_first_of(";[=");
        if (!line.starts_with("uniform ") || end == std::string_view::npos)
            continue;
        line = line.substr(0, end);
        while (!line.empty() && !isWordCharacter(line.back()))
            line.remove_suffix(1);
        std::size_t begin = line.size();
        while (begin > 0 && isWordCharacter(line[begin - 1]))
            --begin;
        names.emplace(line.substr(begin));
    }
    return names;
}

} // namespace texplorer::ui
