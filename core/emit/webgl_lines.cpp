// From C and GLSL 3.30 to JavaScript and GLSL ES 3.00.

#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/webgl.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <array>
#include <regex>

namespace texplorer::emit {
namespace {

struct Rule {
    std::regex pattern;
    const char* with;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> all = [] {
        const auto rule = [](const char* pattern, const char* with) {
            return Rule{std::regex(pattern, std::regex::optimize), with};
        };
        return std::vector<Rule>{
            rule(R"(^static const char (\w+)\[\] =$)", "const $1 ="),
            rule(R"(^static GLuint textures\[\d+\];)", "const textures = [];"),
            rule(R"(^static (GLuint|GLfloat) )", "let "),
            rule(R"(\bconst Matrix (\w+) = \{\{)", "const $1 = ["), // whose numbers are parts of their own
            rule(R"(\}\};)", "];"),
            rule(R"(\bconst (Matrix|GLfloat|double) )", "const "),
            rule(R"(\bMatrix (\w+) = )", "let $1 = "),
            rule(R"(\(GLfloat\))", ""),
            rule(R"(\bmultiplyFloats\()", "multiply("),
            rule(R"(\btan\()", "Math.tan("),
            rule(R"(\* degree\b)", "* Math.PI / 180"),
            rule(R"(\bGL_TEXTURE_1D\b)", "gl.TEXTURE_2D"),
            rule(R"(\bGL_COMPARE_R_TO_TEXTURE\b)", "gl.COMPARE_REF_TO_TEXTURE"),
            rule(R"(\bGL_TRUE\b)", "true"),
            rule(R"(\bGL_FALSE\b)", "false"),
            rule(R"(\bGL_(\w+))", "gl.$1"),
            rule(R"(\bNULL\b)", "0"),
            rule(R"(\b(\d+(?:\.\d*)?(?:e[-+]?\d+)?)f\b)", "$1"),
        };
    }();
    return all;
}

/// "glTexParameteri" as "gl.texParameteri".
std::string methods(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = i == 0 || (std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0 &&
                                       text[i - 1] != '_' && text[i - 1] != '"');
        if (begins && text.compare(i, 2, "gl") == 0 && i + 2 < text.size() &&
            std::isupper(static_cast<unsigned char>(text[i + 2])) != 0) {
            out += "gl.";
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i + 2])));
            i += 2;
        } else
            out += text[i];
    }
    return out;
}

void stagesToEs(GlslPass& pass, const Pass& drawn, bool hasPoints) {
    constexpr std::string_view desktop = "#version 330 core\n";
    constexpr std::string_view es = "#version 300 es\n";
    std::string& vertex = pass.source.vertex.text;
    std::string& fragment = pass.source.fragment.text;
    replaceAll(vertex, desktop, es);
    if (hasPoints) {
        replaceAll(
            vertex, "\nvoid main() {\n",
            "uniform float pointSize; // as glPointSize\n\nvoid main() {\n    gl_PointSize = pointSize;\n");
    }
    for (std::size_t i = 0; i < maxUnits; ++i) {
        if (!pass.units[i] || drawn.units[i].target != Target::Texture1D)
            continue;
        // A line is a picture of one row.
        replaceAll(fragment, fmt::format("sampler1D texture{};", i), fmt::format("sampler2D texture{};", i));
        replaceAll(fragment, fmt::format("sampler1DShadow texture{};", i),
                   fmt::format("sampler2DShadow texture{};", i));
        replaceAll(fragment, fmt::format("textureProj(texture{0}, texCoord{0}", i),
                   fmt::format("textureProj(texture{0}, vec4(texCoord{0}.s, 0.0, texCoord{0}.pq)", i));
    }
    replaceAll(
        fragment,
        "which OpenGL's core profile has not: GL_CLAMP_TO_BORDER for coordinates that end at the edge.",
        "which WebGL has not: a border beyond the edge, for coordinates that end there.");
    std::string head = std::string(es) + "precision highp float;\n";
    for (const std::string_view sampler : {"sampler2D", "sampler3D", "samplerCube", "sampler2DShadow"}) {
        if (fragment.find(fmt::format("uniform {} ", sampler)) != std::string::npos)
            head += fmt::format("precision highp {};\n", sampler);
    }
    // An output that is never written is an error in WebGL, though no fragment comes that far.
    replaceAll(fragment, "\n    discard;\n", "\n    if (alpha >= 0.0) discard; // GL_NEVER: all of them\n");
    replaceAll(fragment, desktop, head);
}

/// What stands between quotation marks is no code, and stays.
std::string translated(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t quote = std::min(text.find_first_of("\"`", at), text.size());
        std::string code = text.substr(at, quote - at);
        for (const Rule& rule : rules())
            code = std::regex_replace(code, rule.pattern, rule.with);
        out += methods(code);
        if (quote == text.size())
            break;
        const std::size_t end = std::min(text.find(text[quote], quote + 1), text.size() - 1);
        out += text.substr(quote, end + 1 - quote);
        at = end + 1;
    }
    return out;
}

} // namespace

void replaceAll(std::string& text, std::string_view word, std::string_view with) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + with.size()))
        text.replace(at, word.size(), with);
}

Line asJavaScript(Line line) {
    for (Part& part : line.parts) {
        if (part.kind != Part::Kind::Comment)
            part.text = translated(part.text);
    }
    if (line.parts.empty())
        return line;
    Part& last = line.parts.back();
    if (last.kind == Part::Kind::Comment && last.text.starts_with("/* ") && last.text.ends_with(" */"))
        last.text = "// " + last.text.substr(3, last.text.size() - 6);
    return line;
}

void toEs(GlslEmission& glsl) {
    const Scene& scene = glsl.emission.scene;
    for (GlslPass& pass : glsl.passes) {
        const Pass& drawn = scene.passes[pass.index];
        const bool hasPoints = std::ranges::any_of(drawnModels(scene, drawn), [&](std::size_t model) {
            return partCorners(scene.models[model]) == 1;
        });
        writeBorders(glsl, pass);
        stagesToEs(pass, drawn, hasPoints);
        findUniforms(pass);
    }
}

} // namespace texplorer::emit
