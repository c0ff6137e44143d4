// The pages of core/emit/webgl_page.cpp and what it is put together from.

#include "tests/random/random_scene.h"
#include "texplorer/emit/program.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

namespace texplorer::webgl_program_test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Result<std::string> pageOf(const Scene& scene, const emit::ProgramOptions& options = {}) {
    emit::TextureCodes codes;
    return emit::program(emit::Flavour::WebGl, scene, {}, options, codes)
        .map([](const std::vector<emit::Line>& lines) { return textOf(lines, false); });
}
std::string textOf(const Scene& scene) {
    const Result<std::string> text = pageOf(scene);
    EXPECT_TRUE(text) << describe(text.error());
    return text.value_or(std::string());
}

std::size_t count(const std::string& text, std::string_view word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++found;
    return found;
}

TEST(WebGlProgram, IsAPageThatNeedsNoOther) {
    const std::string page = textOf(defaultScene());
    EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>\n"), EndsWith("</html>\n"),
                            HasSubstr("role=\"img\" aria-label="), HasSubstr("This page needs WebGL 2")));
    for (const char* word : {"src=", "href=", "http:", "https:", "import ", "fetch("})
        EXPECT_THAT(page, Not(HasSubstr(word)));
}

TEST(WebGlProgram, HasShadersOfEs) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].target = Target::Texture1D;
    EXPECT_THAT(textOf(scene),
                AllOf(HasSubstr("`#version 300 es\n"), HasSubstr("precision highp sampler2D;\n"),
                      HasSubstr("textureProj(texture0, vec4(texCoord0.s, 0.0, texCoord0.pq))"),
                      Not(HasSubstr("sampler1D")), Not(HasSubstr("#version 330")),
                      Not(HasSubstr("TEXTURE_1D"))));
}

/// Nothing of C is left: neither types nor names of OpenGL's functions.
TEST(WebGlProgram, HasNoC) {
    const std::regex leftover(R"((^|[^\w"`])(gl[A-Z]\w*\(|GL_[A-Z]|static |GLfloat|Matrix \w|\d\.\d+f\b))");
    int pages = 0;
    const std::regex comments(R"(//.*|/\*.*\*/)");
    for (int i = 0; i < 16; ++i) {
        const Result<std::string> page = pageOf(random::randomScene(9, i, {}).scene);
        if (!page) {
            EXPECT_EQ(page.error().code, ErrorCode::Unsupported) << describe(page.error());
            continue;
        }
        ++pages;
        std::istringstream lines(*page);
        for (std::string line; std::getline(lines, line);)
            EXPECT_FALSE(std::regex_search(std::regex_replace(line, comments, ""), leftover)) << line;
    }
    EXPECT_GT(pages, 0);
}

TEST(WebGlProgram, FillsWhatWebGlHasNoFormatFor) {
    Scene scene = defaultScene();
    scene.textures[0].internalFormat = InternalFormat::Luminance;
    EXPECT_THAT(textOf(scene), HasSubstr(", \"rrr1\"));"));
    scene.textures[0].internalFormat = InternalFormat::Alpha;
    EXPECT_THAT(textOf(scene), HasSubstr(", \"000a\"));"));
    scene.textures[0].internalFormat = InternalFormat::Rgba;
    EXPECT_THAT(textOf(scene), Not(HasSubstr("keep(")));
}

TEST(WebGlProgram, NamesWhatWebGlHasNot) {
    struct Case {
        const char* sentence;
        void (*change)(Scene& scene);
    };
    for (
        const auto& [sentence, change] :
        {Case{"textures[0].border: WebGL 2 has no textures with a border",
              [](Scene& s) { s.textures[0].border = 1; }},
         Case{"textures[0].wrapT: WebGL 2 has no GL_CLAMP_TO_BORDER, and the page's shader can't replace it "
              "with anisotropy",
              [](Scene& s) {
                  s.textures[0].wrapT = Wrap::ClampToBorder;
                  s.textures[0].maxAnisotropy = 2;
              }},
         Case{"textures[0].wrapS: WebGL 2 has no GL_CLAMP, and the page's shader can't replace it where "
              "only minification averages",
              [](Scene& s) {
                  s.textures[0].wrapS = Wrap::Clamp;
                  s.textures[0].magFilter = MagFilter::Nearest;
                  s.textures[0].minFilter = MinFilter::Linear;
              }},
         Case{
             "passes[0].seamlessCubeMap: WebGL 2 always filters across the edges of a cube map: switch Seamless on",
             [](Scene& s) {
                 s.textures[0].magFilter = MagFilter::Linear;
                 s.textures[0].pattern = Pattern::CubeFaces;
                 s.passes[0].units[0].target = Target::CubeMap;
             }}}) {
        Scene scene = defaultScene();
        change(scene);
        const Result<std::string> page = pageOf(scene);
        ASSERT_FALSE(page);
        EXPECT_EQ(describe(page.error()), sentence);
    }
}

/// Where only the nearest texel is read, GL_CLAMP has no border.
TEST(WebGlProgram, ClampsToTheEdgeWhereThatIsTheSame) {
    Scene scene = defaultScene();
    scene.textures[0].wrapS = Wrap::Clamp;
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::Nearest;
    EXPECT_THAT(textOf(scene),
                HasSubstr("gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);"));
}

/// The border's colour is the shader's, as WebGL has none; what the texture is told is the edge.
TEST(WebGlProgram, MixesTheBorderIn) {
    Scene scene = defaultScene();
    Texture& texture = scene.textures[0];
    texture.wrapS = texture.wrapT = Wrap::ClampToBorder;
    texture.borderColor = {1, 0.5F, 2, 1};
    texture.internalFormat = InternalFormat::Rgb;
    texture.magFilter = MagFilter::Linear;
    texture.minFilter = MinFilter::Linear;
    EXPECT_THAT(textOf(scene),
                AllOf(HasSubstr("gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);"), Not(HasSubstr("float lambda")),
                      HasSubstr("vec4 border0 = vec4(1.0, 0.5, 1.0, 1.0); // GL_TEXTURE_BORDER_COLOR\n"),
                      HasSubstr("bordered(texture0, place0.st, 0.0, true, bvec2(true, true), border0);\n")));
    texture.wrapS = Wrap::Repeat;
    texture.minFilter = MinFilter::LinearMipmapNearest;
    EXPECT_THAT(textOf(scene),
                AllOf(HasSubstr("float lambda0 = lambda(texture0, place0.st);\n"),
                      HasSubstr("bordered(texture0, place0.st, level0, true, bvec2(false, true), border0)")));
    texture.minFilter = MinFilter::Nearest;
    EXPECT_THAT(textOf(scene),
                HasSubstr("bordered(texture0, place0.st, 0.0, lambda0 <= 0.0, bvec2(false, true), border0)"));
    texture.wrapR = Wrap::ClampToBorder;
    scene.passes[0].units[0].target = Target::Texture3D;
    EXPECT_THAT(textOf(scene), AllOf(HasSubstr("vec4 bordered(sampler3D image, vec3 place"),
                                     HasSubstr("lambda0 <= 0.0, bvec3(false, true, true), border0)")));
}

/// What turns about an axis is made by a function, and isn't a list of numbers.
TEST(WebGlProgram, MakesShapes) {
    Scene scene = defaultScene();
    scene.models.resize(1);
    scene.models[0].shape = Shape::Torus;
    scene.models[0].tubeRadius = 0.25F;
    EXPECT_THAT(
        textOf(scene),
        AllOf(HasSubstr("const {vertices: model0Vertices, indices: model0Indices} = torus(0.25, 32, 16);\n"),
              HasSubstr("gl.drawElements(gl.TRIANGLES, model0Indices.length, gl.UNSIGNED_INT, 0);"),
              HasSubstr("function band("), Not(HasSubstr("atob"))));
}

/// What a matrix without a step turns around.
TEST(WebGlProgram, HasTheIdentityWhereItIsNamed) {
    Scene scene = defaultScene();
    EXPECT_THAT(textOf(scene), Not(HasSubstr("const identity")));
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Rotate, .amount = {0, 0, 0}, .angle = 30}};
    EXPECT_THAT(textOf(scene), HasSubstr("const identity = ["));
}

/// A title and names of models come from outside: none of them is markup, or ends the script.
TEST(WebGlProgram, WordsFromOutsideAreNoMarkup) {
    Scene scene = defaultScene();
    scene.models[0].name = "</script><b>*/";
    emit::ProgramOptions options;
    options.title = "<i>\"</title>\n";
    options.about = "</script><!--";
    const Result<std::string> page = pageOf(scene, options);
    ASSERT_TRUE(page);
    EXPECT_EQ(count(*page, "</script"), 1U);
    EXPECT_EQ(count(*page, "</title"), 1U);
    EXPECT_THAT(*page, AllOf(Not(HasSubstr("<!--")), HasSubstr("<title>&lt;i&gt;")));
}

} // namespace
} // namespace texplorer::webgl_program_test
