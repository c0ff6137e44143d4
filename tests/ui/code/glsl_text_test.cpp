#include "app/ui/code/glsl_text.h"
#include "texplorer/glsl/shader_pieces.h"

#include <gmock/gmock.h>

#include <ostream>

namespace texplorer::ui {

static std::ostream& operator<<(std::ostream& out, const GlslToken& token) {
    return out << static_cast<int>(token.kind) << " '" << token.text << "'";
}

} // namespace texplorer::ui

namespace texplorer::ui::glsl_text_test {
namespace {

using Kind = GlslToken::Kind;
using testing::ElementsAre;

TEST(GlslText, LinesAreWithoutTheirEnds) {
    EXPECT_THAT(linesOf("a\n\nb"), ElementsAre("a", "", "b"));
    EXPECT_THAT(linesOf("a\n"), ElementsAre("a"));
    EXPECT_THAT(linesOf(""), ElementsAre());
}

TEST(GlslText, ALongLineIsWrapped) {
    EXPECT_THAT(wrapLine("", 20, 4), ElementsAre(""));
    EXPECT_THAT(wrapLine("vec4 a = b(c, d);", 20, 4), ElementsAre("vec4 a = b(c, d);"));
    EXPECT_THAT(wrapLine("vec4 a = b(ccc, ddd, eee);", 20, 4), ElementsAre("vec4 a = b(ccc, ", "ddd, eee);"));
    EXPECT_THAT(wrapLine("vec4 a = mixed(texture);", 20, 8), ElementsAre("vec4 a = mixed(", "texture);"));
    EXPECT_THAT(wrapLine("        abcdefgh", 12, 4), ElementsAre("        abcd", "efgh"))
        << "not before a word";
    EXPECT_THAT(wrapLine("abcdef", 1, 9), ElementsAre("a", "b", "c", "d", "e", "f"));
    EXPECT_THAT(wrapLine("abc\xC3\xA9z", 4, 0), ElementsAre("abc", "\xC3\xA9z")) << "not within a character";
    EXPECT_EQ(hangingIndent("    x", 60), 8U);
    EXPECT_EQ(hangingIndent("                    x", 16), 8U);
}

TEST(GlslText, UniformsAreFoundByTheirDeclarations) {
    EXPECT_THAT(uniformsOf("uniform vec4 plane0s;\n"
                           "uniform float lodBias0; // GL_TEXTURE_LOD_BIAS\n"
                           "uniform mat4 textureMatrix[4] ;\n"
                           "// uniform vec3 none;\n"
                           "in vec4 position;\n"
                           "uniform\n"),
                ElementsAre("lodBias0", "plane0s", "textureMatrix"));
}

TEST(GlslText, ALineFallsIntoItsKinds) {
    const GlslNames uniforms{"plane"};
    EXPECT_THAT(glslTokens("    vec4 s = dot(plane, x2); // vec4 plane", uniforms),
                ElementsAre(GlslToken{Kind::Plain, "    "}, GlslToken{Kind::Keyword, "vec4"},
                            GlslToken{Kind::Plain, " s = dot("}, GlslToken{Kind::Uniform, "plane"},
                            GlslToken{Kind::Plain, ", x2); "}, GlslToken{Kind::Comment, "// vec4 plane"}));
    EXPECT_THAT(glslTokens("#version 330 core", {}),
                ElementsAre(GlslToken{Kind::Keyword, "#version"}, GlslToken{Kind::Plain, " 330 "},
                            GlslToken{Kind::Keyword, "core"}));
    EXPECT_THAT(glslTokens("", {}), ElementsAre());
    EXPECT_THAT(glslTokens("a/b", {}), ElementsAre(GlslToken{Kind::Plain, "a/b"}));
}

TEST(GlslText, TheStretchesAreTheLine) {
    for (const glsl::ShaderFile& file : glsl::embeddedShaderFiles()) {
        const GlslNames uniforms = uniformsOf(file.text);
        for (const std::string_view line : linesOf(file.text)) {
            std::string joined;
            for (const GlslToken& token : glslTokens(line, uniforms))
                joined += token.text;
            EXPECT_EQ(joined, line) << file.name;
        }
    }
}

} // namespace
} // namespace texplorer::ui::glsl_text_test
