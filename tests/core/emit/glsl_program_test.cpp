#include "tests/random/random_scene.h"
#include "tests/support/temp_dir.h"
#include "texplorer/emit/program.h"
#include "texplorer/glsl/shader_source.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace texplorer::glsl_program_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Result<std::string> programOf(const Scene& scene) {
    emit::TextureCodes codes;
    return emit::program(emit::Flavour::Glsl, scene, {}, {}, codes)
        .map([](const std::vector<emit::Line>& lines) { return textOf(lines, false); });
}
std::string textOf(const Scene& scene) {
    const Result<std::string> text = programOf(scene);
    EXPECT_TRUE(text) << describe(text.error());
    return text.value_or(std::string());
}

/// The text between two words.
std::string between(const std::string& text, const std::string& first, const std::string& last) {
    const std::size_t begin = text.find(first);
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find(last, begin) - begin);
}

TEST(GlslProgram, HasTheShadersOfTheShaderRenderer) {
    const Scene scene = defaultScene();
    const Result<glsl::ShaderSource> source =
        glsl::shaderSource(scene, 0, {glsl::SampledUnit{baseFormat(scene.textures[0].internalFormat)}});
    ASSERT_TRUE(source);
    const std::string literals = between(textOf(scene), "static const char vertexShader[] =", ";\n\n");
    std::string text; // without quotation marks and what C needs around them
    for (std::size_t at = literals.find('"'); at != std::string::npos; at = literals.find('"', at)) {
        const std::size_t end = literals.find("\\n\"", at);
        text += literals.substr(at + 1, end - at - 1) + "\n";
        at = end + 3;
    }
    EXPECT_EQ(text, source->vertex.text);
}

TEST(GlslProgram, SetsTheUniformsThatTheShadersHave) {
    Scene scene = defaultScene();
    scene.passes[0].fog = {.enabled = true, .mode = FogMode::Linear, .start = 2.5F};
    std::string text = textOf(scene);
    EXPECT_THAT(text, HasSubstr("glUniform1f(glGetUniformLocation(program, \"fogStart\"), 2.5f);"));
    EXPECT_THAT(text, Not(HasSubstr("\"fogDensity\"")));
    EXPECT_THAT(text, HasSubstr("setMatrix(program, \"modelView\", modelView);"));
    scene.passes[0].fog.enabled = false;
    scene.passes[0].lighting = false;
    text = textOf(scene);
    EXPECT_THAT(text, AllOf(Not(HasSubstr("fogStart")), Not(HasSubstr("lightPosition")),
                            Not(HasSubstr("\"normalMatrix\"")), Not(HasSubstr("\"modelView\""))));
}

TEST(GlslProgram, GivesModelsTheirOwnTextureMatrices) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {3, 1, 1}}};
    const auto isIn = [](const std::string& part, const char* word) {
        return part.find(word) != std::string::npos;
    };
    const std::string shared = textOf(scene);
    EXPECT_TRUE(isIn(between(shared, "static void init(", "static void place("), "Matrix unit0Matrix = "));
    scene.models[1].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
    const std::string own = textOf(scene);
    EXPECT_THAT(own, AllOf(HasSubstr("Matrix model0Unit0Matrix = scaling(3.0f, 1.0f, 1.0f);\n"),
                           HasSubstr("model1Unit0Matrix = multiply(model1Unit0Matrix, "
                                     "translation(0.5f, 0.0f, 0.0f));\n"),
                           HasSubstr("\"textureMatrix0\", model1Unit0Matrix);"),
                           Not(HasSubstr("Matrix unit0Matrix"))));
}

TEST(GlslProgram, HasNoFixedFunction) {
    for (int i = 0; i < 12; ++i) {
        const Result<std::string> text = programOf(random::randomScene(5, i, {}).scene);
        for (const char* name :
             {"glBegin", "glMatrixMode", "glLight", "glTexEnv", "glTexGen", "glEnableClientState",
              "GL_TEXTURE_PRIORITY", "GL_DEPTH_TEXTURE_MODE", "GL_QUADS", "GL_LUMINANCE8"})
            EXPECT_THAT(text.value_or(std::string()), Not(HasSubstr(name)));
    }
}

/// Table 3.20: formats that the core profile has removed.
TEST(GlslProgram, SwizzlesWhatTheCoreProfileHasNoFormatFor) {
    Scene scene = defaultScene();
    scene.textures[0].internalFormat = InternalFormat::Luminance;
    EXPECT_THAT(
        textOf(scene),
        AllOf(
            HasSubstr("swizzle[] = {GL_RED, GL_RED, GL_RED, GL_ONE}; /* what a shader gets: GL_LUMINANCE */"),
            HasSubstr("GL_R8,")));
    scene.textures[0].internalFormat = InternalFormat::Alpha;
    EXPECT_THAT(textOf(scene), HasSubstr("swizzle[] = {GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA};"));
    scene.textures[0].internalFormat = InternalFormat::Rgba;
    EXPECT_THAT(textOf(scene), Not(HasSubstr("SWIZZLE")));
    for (const auto& [format, name] : {std::pair{InternalFormat::Components1, "GL_R8,"},
                                       std::pair{InternalFormat::Components4, "GL_RGBA8,"},
                                       std::pair{InternalFormat::Luminance12Alpha4, "GL_RGBA16,"},
                                       std::pair{InternalFormat::Rgb12, "GL_RGB12,"},
                                       std::pair{InternalFormat::SluminanceAlpha, "GL_SRGB8_ALPHA8,"},
                                       std::pair{InternalFormat::CompressedIntensity, "GL_COMPRESSED_RED,"},
                                       std::pair{InternalFormat::CompressedSrgb, "GL_COMPRESSED_SRGB,"},
                                       std::pair{InternalFormat::DepthComponent, "GL_DEPTH_COMPONENT24,"}}) {
        scene.textures[0].internalFormat = format;
        EXPECT_THAT(textOf(scene), HasSubstr(name));
    }
}

TEST(GlslProgram, SaysWhatTheCoreProfileHasNot) {
    Scene scene = defaultScene();
    scene.textures[0].border = 1;
    const Result<std::string> refused = programOf(scene);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Unsupported);
    EXPECT_EQ(describe(refused.error()),
              "textures[0].border: textures have no border in OpenGL 3.3's core profile");
}

/// Where only the nearest texel is read, GL_CLAMP has no border.
TEST(GlslProgram, ClampsToTheEdgeWhereThatIsTheSame) {
    Scene scene = defaultScene();
    scene.textures[0].wrapS = Wrap::Clamp;
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::Nearest;
    EXPECT_THAT(textOf(scene),
                HasSubstr("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);"));
}

TEST(GlslProgram, IsGivenTheSecondsWhereSomethingMoves) {
    Scene scene = defaultScene();
    for (Model& model : scene.models)
        model.spin = {};
    EXPECT_THAT(textOf(scene), AllOf(HasSubstr("draw(width, height);"), HasSubstr("glfwWaitEvents();")));
    scene.models[0].spin.y = 30;
    EXPECT_THAT(textOf(scene), AllOf(HasSubstr("draw(width, height, glfwGetTime());"),
                                     HasSubstr(" + 30.0f * seconds, 0.0f, 1.0f, 0.0f)")));
}

TEST(GlslProgram, EachPassHasItsOwnProgram) {
    Scene scene = defaultScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].lighting = !scene.passes[0].lighting;
    scene.passes[1].blend = true;
    EXPECT_THAT(textOf(scene),
                AllOf(HasSubstr("pass0Program = newProgram(pass0VertexShader, pass0FragmentShader);"),
                      HasSubstr("glUseProgram(pass1Program);"), HasSubstr("glDisable(GL_BLEND);"),
                      HasSubstr("glEnable(GL_BLEND);")));
}

TEST(GlslProgram, CountsOnlyThePassesThatAreSeen) {
    Scene scene = defaultScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[0].picture = 3; // which nothing shows
    EXPECT_THAT(textOf(scene), AllOf(HasSubstr("glUseProgram(program);"), Not(HasSubstr("pass1Program"))));
}

/// Random scenes: the result is valid C, or an error.
TEST(GlslProgram, HasOneBufferOfEmbossedCoordinates) {
    Scene scene = defaultScene();
    scene.models = {{.shape = Shape::Quad}};
    scene.passes[0].units[1] = {.enabled = true, .emboss = {.enabled = true}};
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].units[0].emboss.enabled =
        true; // another vertex array object, because the coordinates differ here
    const std::string text = textOf(scene);
    const std::size_t made = text.find("model0EmbossedBuffer1 = newBuffer(");
    ASSERT_NE(made, std::string::npos);
    EXPECT_EQ(text.find("model0EmbossedBuffer1 = newBuffer(", made + 1), std::string::npos);
    EXPECT_THAT(
        text.substr(made),
        HasSubstr("    glBindBuffer(GL_ARRAY_BUFFER, model0EmbossedBuffer1);\n    attribute(9, 4, 0, 0);"));
}

TEST(GlslProgram, OfRandomScenesIsC) {
    const test::TempDir folder;
    const std::vector<std::string> files{"a.png", "*/ int broken; /*", "line\nbreak.png",
                                         "/*/ what?"
                                         "?/\\",
                                         "é\xff.dds"};
    std::string names;
    int programs = 0;
    for (int i = 0; i < 16; ++i) {
        const Result<std::string> text = programOf(random::randomScene(7, i, files).scene);
        if (!text) {
            EXPECT_EQ(text.error().code, ErrorCode::Unsupported) << describe(text.error());
            continue;
        }
        const std::filesystem::path file = folder / fmt::format("random{}.c", i);
        std::ofstream(file) << *text;
        names += fmt::format(" '{}'", file.string());
        ++programs;
    }
    EXPECT_GT(programs, 3);
    const std::string command = TEXPLORER_C_COMPILER " -std=c99 -Wall -Wextra -Werror -fsyntax-only" + names;
    EXPECT_EQ(std::system(command.c_str()), 0); // which printed what is wrong
}

} // namespace
} // namespace texplorer::glsl_program_test
