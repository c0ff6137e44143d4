#include "tests/random/random_scene.h"
#include "tests/support/temp_dir.h"
#include "texplorer/emit/program.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace texplorer::emit_test {
namespace {

using emit::Line;
using emit::Part;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

/// Self-contained: what takes the place of GLU's shapes is tested here, its calls by book_calls_test.
std::vector<Line> programOf(const Scene& scene, const ImageSource& images = {}) {
    emit::TextureCodes codes;
    const auto lines = emit::program(emit::Flavour::Fixed, scene, images, {.selfContained = true}, codes);
    EXPECT_TRUE(lines) << describe(lines.error());
    return lines.value_or(std::vector<Line>{});
}

/// Lines without their indentation.
std::vector<std::string> linesOf(const Scene& scene, bool all) {
    std::vector<std::string> lines;
    std::istringstream text(textOf(programOf(scene), all));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    return lines;
}
std::vector<std::string> needed(const Scene& scene) {
    return linesOf(scene, false);
}
std::vector<std::string> all(const Scene& scene) {
    return linesOf(scene, true);
}

bool showsDrawn(const Scene& scene, const Unit& unit) {
    const auto index = static_cast<std::size_t>(unit.texture);
    return index < scene.textures.size() && isDrawn(scene.textures[index].source);
}

/// A picture of passes as it is drawn: programs refuse the rest.
Texture plainPicture(const Texture& texture) {
    Texture plain;
    static_cast<SamplerState&>(plain) = texture;
    plain.source = SourceKind::Picture;
    plain.picture = texture.picture;
    plain.pictureSize = texture.pictureSize;
    plain.frames = texture.frames;
    plain.pictureCall = PictureCall::CopyTexSubImage;
    return plain;
}

/// Programs of scenes, two files each, for the C compiler: valid C, or an error.
class CompiledCalls : public testing::Test {
protected:
    void add(const Scene& drawn, const std::string& name) {
        Scene scene = drawn;
        scene.timeline = {}; // programs refuse some of these
        for (Texture& texture : scene.textures) {
            if (texture.source == SourceKind::LightDepth) // programs refuse its other formats
                texture.internalFormat = InternalFormat::DepthComponent24;
            if (texture.source == SourceKind::Picture)
                texture = plainPicture(texture);
        }
        for (Pass& pass : scene.passes) {
            for (Unit& unit : pass.units)
                unit.target = showsDrawn(scene, unit) ? Target::Texture2D : unit.target;
        }
        const std::vector<Line> lines = programOf(scene);
        for (const bool all : {false, true}) {
            const std::filesystem::path file = folder_ / fmt::format("{}{}.c", name, all ? "-all" : "");
            std::ofstream(file) << textOf(lines, all);
            files_ += fmt::format(" '{}'", file.string());
        }
    }
    void expectToCompile() const {
        const std::string command =
            TEXPLORER_C_COMPILER " -std=c99 -Wall -Wextra -Werror -fsyntax-only" + files_;
        EXPECT_EQ(std::system(command.c_str()), 0); // which printed what is wrong
    }

private:
    test::TempDir folder_;
    std::string files_;
};

TEST_F(CompiledCalls, OfExamplesAreC) {
    add(defaultScene(), "default");
    add(Scene{}, "empty");
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(TEXPLORER_SOURCE_DIR "/assets/scenes")) {
        const Result<std::string> text = readText(entry.path());
        ASSERT_TRUE(text);
        const Result<Scene> scene = parseScene(*text);
        ASSERT_TRUE(scene) << entry.path();
        add(*scene, entry.path().stem().string());
        ++count;
    }
    EXPECT_GT(count, 10);
    expectToCompile();
}

// Names of files come from outside: they must not end a comment or begin another line.
TEST_F(CompiledCalls, OfRandomScenesAreC) {
    const std::vector<std::string> files{"a.png", "*/ int broken; /*", "line\nbreak.png",
                                         "/*/ what?"
                                         "?/\\",
                                         "é\xff.dds"};
    for (int i = 0; i < 8; ++i)
        add(random::randomScene(7, i, files).scene, fmt::format("random{}", i));
    expectToCompile();
}

/// The expected value in a line.
std::string expectedText(const Scene& scene, const Part& part) {
    const Result<std::string> value = getParam(scene, part.path);
    if (!value)
        return "no such parameter: " + part.path;
    if (part.kind != Part::Kind::Number) {
        const EnumRow* format = findRow(internalFormatRows, *value);
        const bool isSized =
            format && part.text == rowOf(factsOf(static_cast<InternalFormat>(format->value)).sized).name;
        return isSized ? part.text : *value; // of packed pixels the program names the bits
    }
    std::istringstream numbers(*value);
    std::string number;
    for (int i = 0; i <= std::max(part.component, 0); ++i) {
        if (!std::getline(numbers, number, ','))
            number = i == 3 ? "1" : "0"; // of a vertex: r and q
    }
    return number;
}

TEST(EmittedValues, AreThoseOfTheParametersThatTheyName) {
    for (int i = 0; i < 40; ++i) {
        Scene scene = random::randomScene(11, i, {}).scene;
        scene.timeline = {}; // programs refuse some of these
        for (Texture& texture : scene.textures) {
            if (isDrawn(texture.source)) // programs refuse some of these
                texture.source = SourceKind::Pattern;
        }
        int numbers = 0;
        for (const Line& line : programOf(scene)) {
            for (const Part& part : line.parts) {
                if (part.path.empty() || (part.kind != Part::Kind::Number && part.kind != Part::Kind::Choice))
                    continue;
                ++numbers;
                const std::string expected = expectedText(scene, part);
                if (part.kind == Part::Kind::Choice) {
                    EXPECT_EQ(part.text, expected) << part.path;
                } else {
                    EXPECT_EQ(std::stod(part.text), (part.negated ? -1 : 1) * std::stod(expected))
                        << part.path << " in " << textOf(line);
                }
            }
        }
        EXPECT_GT(numbers, 5);
    }
}

TEST(EmittedCalls, CarryTheValuesAndDeclareArrays) {
    Scene scene = defaultScene();
    scene.textures[0].wrapS = Wrap::MirroredRepeat;
    scene.textures[0].borderColor = {1, 0, 0.5F, 1};
    EXPECT_THAT(
        needed(scene),
        IsSupersetOf({"glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);",
                      "const GLfloat texture0BorderColor[] = {1.0f, 0.0f, 0.5f, 1.0f};",
                      "glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, texture0BorderColor);"}));
}

TEST(EmittedCalls, AreNeededWhereTheyChangeSomething) {
    Scene scene = defaultScene();
    scene.textures[0].wrapT = Wrap::Clamp;
    const char* same = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);";
    EXPECT_THAT(needed(scene), Contains("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);"));
    EXPECT_THAT(needed(scene), Not(Contains(same)));
    EXPECT_THAT(all(scene), Contains(same));
    EXPECT_THAT(needed(scene), Contains("glEnable(GL_COLOR_MATERIAL);")) << "OpenGL begins without";
}

// A frame starts with the state that the last one left: each pass sets all state that another pass changes.
TEST(EmittedCalls, OfPassesAreTheSameInEveryFrame) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].envMode = EnvMode::Decal;
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].blend = true;
    scene.passes[1].units[0].envMode = EnvMode::Modulate;
    scene.passes[1].units[1] = scene.passes[1].units[0];
    scene.passes[1].units[1].target = Target::Texture1D;
    const std::vector<std::string> lines = needed(scene);
    const auto frame = std::ranges::find(lines, "/* a frame */");
    const auto second = std::ranges::find(lines, "/* pass 1 */");
    ASSERT_LT(frame, second);
    ASSERT_NE(second, lines.end());
    const std::vector<std::string> first(frame, second);
    const std::vector<std::string> rest(second, lines.end());
    EXPECT_THAT(first, Contains("glDisable(GL_BLEND);"))
        << "which the second pass of the frame before has on";
    EXPECT_THAT(first, Contains("glDisable(GL_TEXTURE_1D);"));
    EXPECT_THAT(first, Contains("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);"));
    EXPECT_THAT(rest, Contains("glEnable(GL_BLEND);"));
    EXPECT_THAT(rest, Contains("glEnable(GL_TEXTURE_1D);"));
    EXPECT_THAT(rest, Contains("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);"));
    EXPECT_THAT(rest, Not(Contains("glEnable(GL_DEPTH_TEST);"))) << "the first pass has it, too";

    scene.passes[1].enabled = false;
    EXPECT_THAT(needed(scene), Not(Contains("/* pass 1 */")));
    EXPECT_THAT(needed(scene), Not(Contains("glDisable(GL_BLEND);")));
}

TEST(EmittedCalls, OfTwoParametersAreOneLine) {
    Scene scene = defaultScene();
    scene.passes[0].alphaFunc = CompareFunc::Greater;
    scene.passes[0].alphaRef = 0.5F;
    EXPECT_THAT(needed(scene), Contains("glAlphaFunc(GL_GREATER, 0.5f);").Times(1));
    EXPECT_THAT(all(scene), Contains("glDisable(GL_ALPHA_TEST);"));
    for (const Line& line : programOf(scene)) {
        if (textOf(line).starts_with("glAlphaFunc")) {
            EXPECT_TRUE(mentions(line, "passes[0].alphaFunc"));
            EXPECT_TRUE(mentions(line, "passes[0].alphaRef"));
        }
    }
}

TEST(EmittedTextures, NameTheTargetThatTheyAreShownAs) {
    Scene scene = defaultScene();
    scene.textures[0].mipmaps = MipPolicy::None;
    const auto upload = [&](Target target) {
        scene.passes[0].units[0].target = target;
        for (const std::string& line : needed(scene)) {
            if (line.starts_with("glTexImage"))
                return line;
        }
        return std::string();
    };
    EXPECT_EQ(upload(Target::Texture1D),
              "glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);");
    EXPECT_EQ(upload(Target::Texture2D),
              "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);");
    EXPECT_EQ(upload(Target::Texture3D),
              "glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 64, 64, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);");
    EXPECT_EQ(upload(Target::CubeMap),
              "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, 64, 64, 0, "
              "GL_RGBA, GL_UNSIGNED_BYTE, texels + face * 64 * 64 * 4);");
    EXPECT_THAT(all(scene), Contains("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_REPEAT);"));
    scene.textures[0].border = 1;
    EXPECT_THAT(upload(Target::Texture2D), HasSubstr("66, 66, 1, GL_RGBA")) << "the edge once more";
    scene.textures[0].border = 2;
    EXPECT_THAT(upload(Target::Texture2D), HasSubstr("66, 66, 2, GL_RGBA")) << "as OpenGL refuses it";
    scene.textures[0].border = 0;
    scene.textures[0].internalFormat = InternalFormat::Bgr;
    EXPECT_THAT(upload(Target::Texture2D), HasSubstr("0, GL_BGR, 64, 64, 0, GL_RGBA"));
    scene.textures[0].internalFormat = InternalFormat::Components3;
    EXPECT_THAT(upload(Target::Texture2D), HasSubstr("0, 3, 64, 64, 0, GL_RGBA"));
}

TEST(EmittedTextures, AreComputedListedOrPacked) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = Pattern::CheckerRed;
    EXPECT_THAT(needed(scene), IsSupersetOf({"checkerboard(texels, 64, 16, 255, 0, 0);",
                                             "halve(texels, &width, &height); /* the next mip level */"}));
    scene.textures[0].pattern = Pattern::Gradient;
    EXPECT_THAT(needed(scene), Contains("gradient(texels);"));
    scene.textures[0].pattern = Pattern::MipColors;
    scene.textures[0].mipmaps = MipPolicy::Colored;
    EXPECT_THAT(needed(scene), Contains(StartsWith("fill(texels")).Times(7));
    scene.textures[0].pattern = Pattern::Brick;
    EXPECT_THAT(needed(scene), Contains("unpack(texture0Packed, sizeof texture0Packed, texels);"));
    scene.textures[0] = {.pattern = Pattern::ColorLine};
    EXPECT_THAT(needed(scene),
                Contains("255, 0, 0, 255, 255, 255, 0, 255, 0, 255, 0, 255, 0, 255, 255, 255,"));
    scene.textures[0] = {.source = SourceKind::File, .file = "none.png"};
    EXPECT_THAT(needed(scene), Contains("/* the file isn't there */"));
}

TEST(EmittedTextures, LeaveOutTheLevelThatIsMissing) {
    Scene scene = defaultScene();
    scene.textures[0].mipmaps = MipPolicy::Missing;
    EXPECT_THAT(needed(scene), Contains("if (level != 3) /* this one is missing */"));
}

// OpenGL binds a texture object to one target for good.
TEST(EmittedTextures, ShownOnTwoTargetsAreTwoObjects) {
    Scene scene = defaultScene();
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].target = Target::Texture1D;
    EXPECT_THAT(needed(scene),
                IsSupersetOf({"static GLuint textures[2];", "glBindTexture(GL_TEXTURE_2D, textures[0]);",
                              "glBindTexture(GL_TEXTURE_1D, textures[1]);"}));
}

TEST(EmittedTextures, LeaveOutTheCoordinatesThatATargetHasNot) {
    Scene scene = defaultScene();
    const auto wraps = [&](Target target) {
        scene.passes[0].units[0].target = target;
        std::string letters;
        for (const std::string& call : all(scene)) {
            if (const std::size_t at = call.find("GL_TEXTURE_WRAP_"); at != std::string::npos)
                letters += call[call.find(", GL_REPEAT") - 1];
        }
        return letters;
    };
    EXPECT_EQ(wraps(Target::Texture1D), "S");
    EXPECT_EQ(wraps(Target::Texture2D), "ST");
    EXPECT_EQ(wraps(Target::CubeMap), "ST");
    EXPECT_EQ(wraps(Target::Texture3D), "STR");
}

TEST(EmittedTextures, CompareDepthsOfDepthTexturesAlone) {
    Scene scene = defaultScene();
    scene.textures[0].compareMode = CompareMode::RToTexture;
    const char* call = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);";
    EXPECT_THAT(all(scene), Not(Contains(call)));
    scene.textures[0].internalFormat = InternalFormat::DepthComponent16;
    EXPECT_THAT(needed(scene), Contains(call));
}

TEST(EmittedTextures, UploadEachLevelThatIsGiven) {
    Scene scene = defaultScene();
    scene.textures[0].mipmaps = MipPolicy::Given;
    scene.textures[0].levels.assign(2, {.pattern = Pattern::Brick});
    EXPECT_THAT(needed(scene), Contains(StartsWith("glTexImage2D(")).Times(3));
    EXPECT_THAT(needed(scene), Contains(HasSubstr("glTexImage2D(GL_TEXTURE_2D, 2, GL_RGBA, 16, 16, 0")));
}

TEST(EmittedPasses, SetOfFogWhatItsModeAsksFor) {
    Scene scene = defaultScene();
    Fog& fog = scene.passes[0].fog;
    fog = {.mode = FogMode::Linear, .density = 0.5F, .start = 2, .end = 7, .color = {1, 0.5F, 0, 1}};
    EXPECT_THAT(all(scene), Contains("glDisable(GL_FOG);"));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("glFog"))));
    fog.enabled = true;
    EXPECT_THAT(needed(scene), IsSupersetOf({"glEnable(GL_FOG);", "glFogi(GL_FOG_MODE, GL_LINEAR);",
                                             "glFogf(GL_FOG_START, 2.0f);", "glFogf(GL_FOG_END, 7.0f);",
                                             "const GLfloat fogColor[] = {1.0f, 0.5f, 0.0f, 1.0f};",
                                             "glFogfv(GL_FOG_COLOR, fogColor);"}));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("GL_FOG_DENSITY"))));
    fog.mode = FogMode::Exp2;
    EXPECT_THAT(needed(scene), Contains("glFogf(GL_FOG_DENSITY, 0.5f);"));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("GL_FOG_START"))));
}

// A driver of OpenGL 2.1 does not know the enumerator.
TEST(EmittedPasses, NameSeamlessCubeMapsWhereThereIsACubeMap) {
    Scene scene = defaultScene();
    scene.passes[0].seamlessCubeMap = true;
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("SEAMLESS"))));
    scene.passes[0].units[0].target = Target::CubeMap;
    EXPECT_THAT(needed(scene), Contains("glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);"));
}

TEST(EmittedUnits, SetCombineUnderItsModeAlone) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].combine.source1Rgb = CombineSource::Constant;
    const std::string call = "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_CONSTANT);";
    EXPECT_THAT(all(scene), Not(Contains(call)));
    scene.passes[0].units[0].envMode = EnvMode::Combine;
    EXPECT_THAT(needed(scene), Contains(call).Times(1));
    EXPECT_THAT(all(scene), Contains("glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);"));
    EXPECT_THAT(needed(scene), Not(Contains(HasSubstr("GL_RGB_SCALE"))));
}

// OpenGL multiplies eye planes by the inverse of the modelview matrix, which is the camera's during a frame.
TEST(EmittedUnits, SetEyePlanesWhileTheMatrixIsTheIdentity) {
    Scene scene = defaultScene();
    TexGen& t = scene.passes[0].units[0].texGenT;
    EXPECT_THAT(needed(scene), Not(Contains(HasSubstr("TEXTURE_GEN"))));
    t.enabled = true;
    t.eyePlane = {0, 0, 1, 0};
    const auto after = [&] {
        const std::vector<std::string> lines = needed(scene);
        const auto enable = std::ranges::find(lines, "glEnable(GL_TEXTURE_GEN_T);");
        return std::vector<std::string>(enable, std::min(enable + 6, lines.end()));
    };
    EXPECT_THAT(after(), IsSupersetOf({"const GLfloat unit0TEyePlane[] = {0.0f, 0.0f, 1.0f, 0.0f};",
                                       "glTexGenfv(GL_T, GL_EYE_PLANE, unit0TEyePlane);"}));
    EXPECT_THAT(after(), Not(Contains("glPushMatrix();"))) << "it is the identity when the program begins";
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].units[0].texGenT.eyePlane = {0, 0, 2, 0};
    EXPECT_THAT(after(),
                ElementsAre("glEnable(GL_TEXTURE_GEN_T);", "glPushMatrix();", "glLoadIdentity();",
                            "const GLfloat pass0Unit0TEyePlane[] = {0.0f, 0.0f, 1.0f, 0.0f};",
                            "glTexGenfv(GL_T, GL_EYE_PLANE, pass0Unit0TEyePlane);", "glPopMatrix();"));
    scene.passes.pop_back();
    TexGen& linear = scene.passes[0].units[0].texGenT; // the passes have moved
    linear.mode = TexGenMode::ObjectLinear;
    linear.objectPlane = {0, 0, 2, 0};
    EXPECT_THAT(needed(scene), IsSupersetOf({"glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);",
                                             "glTexGenfv(GL_T, GL_OBJECT_PLANE, unit0TObjectPlane);"}));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("EYE_PLANE"))));
}

TEST(EmittedUnits, TurnWithTheTime) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Rotate,
                                        .amount = {0, 0, 1},
                                        .angle = 30,
                                        .angleRate = 15,
                                        .pivot = {0.5F, 0.5F, 0}}};
    const std::vector<std::string> lines = needed(scene);
    EXPECT_THAT(lines, Contains("static void draw(int width, int height, double seconds)"));
    const auto mode = std::ranges::find(lines, "glMatrixMode(GL_TEXTURE);");
    ASSERT_GT(lines.end() - mode, 6);
    EXPECT_THAT(std::vector<std::string>(mode + 1, mode + 6),
                ElementsAre("glLoadIdentity();", "glTranslatef(0.5f, 0.5f, 0.0f);",
                            "glRotatef((GLfloat)fmod(30.0f + 15.0f * seconds, 360.0), 0.0f, 0.0f, 1.0f);",
                            "glTranslatef(-0.5f, -0.5f, 0.0f);", "glMatrixMode(GL_MODELVIEW);"));
}

TEST(EmittedModels, AreListsShapesOrArrays) {
    const auto of = [](Model model, Unit second = {}) {
        Scene scene = defaultScene();
        scene.models = {std::move(model)};
        scene.passes[0].units[1] = second;
        return needed(scene);
    };
    EXPECT_THAT(of({.shape = Shape::Sphere, .slices = 9, .stacks = 7}), Contains("model0 = sphere(9, 7);"));
    EXPECT_THAT(of({.shape = Shape::Torus, .slices = 9, .stacks = 2}),
                Contains("model0 = torus(0.4f, 9, 3);"));
    EXPECT_THAT(of({.shape = Shape::Cylinder, .slices = 9, .stacks = 7, .topRadius = 0}),
                Contains("model0 = cylinder(0.0f, 9, 7);"));
    EXPECT_THAT(of({.shape = Shape::PartialDisk, .innerRadius = 0.5F, .startAngle = 10, .sweepAngle = 90}),
                Contains("model0 = disk(0.5f, 32, 16, 10.0f, 90.0f);"));
    EXPECT_THAT(of({.shape = Shape::PartialDisk, .startAngle = 10, .sweepAngle = -90}),
                Contains("model0 = disk(0.0f, 32, 16, 10.0f + -90.0f, 90.0f);"));
    EXPECT_THAT(of({.shape = Shape::Cube}), Contains(HasSubstr("glVertex3f(")).Times(24));
    EXPECT_THAT(
        of({.shape = Shape::Quad}, {.enabled = true}),
        Contains("glMultiTexCoord2f(GL_TEXTURE0, 1.0f, 0.0f); glMultiTexCoord2f(GL_TEXTURE1, 1.0f, 0.0f); "
                 "glVertex3f(1.0f, -1.0f, 0.0f);"));
    EXPECT_THAT(of({.shape = Shape::Teapot}), Contains(StartsWith("glDrawElements(GL_TRIANGLES, ")).Times(1));
    Model lines{.shape = Shape::Mesh, .lineWidth = 3};
    lines.mesh.primitive = Primitive::LineStrip;
    lines.mesh.positions.resize(5);
    EXPECT_THAT(of(lines), IsSupersetOf({"glLineWidth(3.0f);", "glBegin(GL_LINE_STRIP);"}));
    lines.mesh.indices = {0, 1, 99, 2};
    EXPECT_THAT(of(lines),
                IsSupersetOf({"static const GLuint model0Indices[] = {0, 1, 2};",
                              "glDrawElements(GL_LINE_STRIP, 3, GL_UNSIGNED_INT, model0Indices);"}));
}

// With many vertices the readable part stays short: their numbers are on one line.
TEST(EmittedModels, AreBounded) {
    Scene scene = defaultScene();
    Model points{.shape = Shape::Mesh};
    points.mesh.primitive = Primitive::Points;
    points.mesh.positions.resize(emit::maxWrittenVertices);
    scene.models = {points};
    EXPECT_THAT(needed(scene),
                Contains(HasSubstr("glVertex3f(")).Times(static_cast<int>(emit::maxWrittenVertices)));
    scene.models[0].mesh.positions.resize(maxMeshVertices);
    scene.models[0].texCoords[0].resize(maxMeshVertices);
    const std::vector<Line> lines = programOf(scene);
    EXPECT_LT(lines.size(), 400U);
    const auto positions = std::ranges::find_if(lines, [](const Line& line) {
        return line.data && textOf(line).starts_with("static const GLfloat model0Positions[196608]");
    });
    ASSERT_NE(positions, lines.end());
    EXPECT_EQ(std::ranges::count(positions->data->text(), ','), 196608);
}

TEST(EmittedModels, AreLeftOutWithoutAPrimitive) {
    for (const emit::Flavour flavour : {emit::Flavour::Fixed, emit::Flavour::Glsl}) {
        Scene scene = defaultScene();
        scene.models[0].shape = Shape::Mesh;
        scene.models[0].mesh.positions = {{0, 0, 0}, {1, 0, 0}};
        emit::TextureCodes codes;
        const auto tooFew = emit::program(flavour, scene, {}, {}, codes);
        scene.models[0].visible = false;
        const auto invisible = emit::program(flavour, scene, {}, {}, codes);
        ASSERT_TRUE(tooFew && invisible);
        EXPECT_EQ(textOf(*tooFew, false), textOf(*invisible, false));
        scene.timeline.keys = {{0, "models[0].visible", "true", Easing::Hold}};
        const auto keyed = emit::program(flavour, scene, {}, {}, codes);
        ASSERT_TRUE(keyed);
        EXPECT_EQ(textOf(*keyed, false), textOf(*invisible, false));
    }
}

TEST(EmittedModels, SetTheirOwnMaterialAndGiveTheScenesBack) {
    Scene scene = defaultScene();
    scene.models[0].ownMaterial = true;
    scene.models[0].material.shininess = 5;
    std::vector<std::string> set;
    for (const std::string& line : needed(scene)) {
        if (line.find("GL_SHININESS") != std::string::npos)
            set.push_back(line);
    }
    EXPECT_THAT(set, ElementsAre("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 5.0f);", // in init()
                                 "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 5.0f);",
                                 "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32.0f);"));
}

TEST(EmittedModels, HaveCoordinatesThatATextureMatrixLooksAt) {
    Scene scene = defaultScene();
    scene.models = {{.shape = Shape::Sphere}};
    Unit& unit = scene.passes[0].units[0];
    unit.texGenS = {.enabled = true, .mode = TexGenMode::SphereMap};
    unit.texGenT = unit.texGenS;
    const auto pointer = HasSubstr("glTexCoordPointer(");
    EXPECT_THAT(needed(scene), Not(Contains(pointer)));
    unit.matrix = {{.op = MatrixOp::Multiply}}; // r and q go into s and t, too
    EXPECT_THAT(needed(scene), Contains(pointer));
    unit.texGenR = unit.texGenS;
    unit.texGenQ = unit.texGenS;
    EXPECT_THAT(needed(scene), Not(Contains(pointer)));
}

TEST(EmittedModels, SwitchColorMaterialOnBeforeTheirColor) {
    Scene scene = defaultScene();
    scene.material.colorMaterial = false;
    scene.models = {{.shape = Shape::Quad, .ownMaterial = true, .material = {.colorMaterial = true}}};
    const std::vector<std::string> lines = needed(scene);
    const auto on = std::ranges::find(lines, "glEnable(GL_COLOR_MATERIAL);");
    EXPECT_THAT(std::vector(on, lines.end()), Contains(StartsWith("glColor4f(")));
}

TEST(EmittedModels, HaveNoMaterialButAColorWithoutLight) {
    Scene scene = defaultScene();
    const auto lit = AnyOf(HasSubstr("glMaterial"), HasSubstr("glLight"), HasSubstr("GL_COLOR_MATERIAL"));
    EXPECT_THAT(needed(scene), Contains(lit));
    scene.passes[0].lighting = false;
    EXPECT_THAT(needed(scene), Not(Contains(lit)));
    EXPECT_THAT(all(scene), Contains(lit));
    EXPECT_THAT(needed(scene), Contains("glColor4f(1.0f, 1.0f, 1.0f, 1.0f);"));
}

TEST(EmittedModels, ArePushedWhereTheyAreNotWhereTheirVerticesSay) {
    Scene scene = defaultScene();
    scene.models = {{.shape = Shape::Cube}};
    EXPECT_THAT(needed(scene), Not(Contains("glPushMatrix();")));
    scene.models[0].size = 2;
    EXPECT_THAT(needed(scene), IsSupersetOf({"glPushMatrix();", "glPopMatrix();"}));
}

TEST(EmittedModels, AreTrianglesWhereAStripCoversItself) {
    Scene scene = defaultScene();
    Model strip{.shape = Shape::Mesh};
    strip.mesh = {.primitive = Primitive::QuadStrip,
                  .positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 1}, {2, 1, 1}}};
    scene.models = {strip};
    EXPECT_THAT(needed(scene), Contains("glBegin(GL_QUAD_STRIP);"));
    scene.models[0].mesh.indices = {0, 1, 2, 3};
    EXPECT_THAT(needed(scene), Contains("glDrawElements(GL_QUAD_STRIP, 4, GL_UNSIGNED_INT, model0Indices);"));
    scene.models[0].mesh.indices = {0, 1, 3, 2}; // as a bow tie
    EXPECT_THAT(needed(scene), Contains("glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, model0Indices);"));
    scene.models[0] = strip;
    scene.models[0].mesh.positions.edit()[5].z = 2; // no more flat
    EXPECT_THAT(needed(scene), Contains("glDrawElements(GL_TRIANGLES, 12, GL_UNSIGNED_INT, model0Indices);"));
}

TEST(EmittedModels, BeginWithTheMaterialOfTheFirst) {
    Scene scene = defaultScene();
    scene.material.shininess = 7;
    scene.models = {{.shape = Shape::Quad, .ownMaterial = true, .material = {.shininess = 9}}};
    EXPECT_THAT(needed(scene), AllOf(Contains("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 9.0f);"),
                                     Not(Contains("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 7.0f);"))));
}

TEST(EmittedTextures, HaveAMaxLevelThatIsNotBelowTheBaseLevelWhichAloneIsRead) {
    Scene scene = defaultScene();
    Texture& texture = scene.textures[0];
    texture.baseLevel = 3;
    texture.maxLevel = 1;
    texture.minFilter = MinFilter::Linear;
    const auto raised = StartsWith("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);");
    EXPECT_THAT(needed(scene), Contains(raised));
    texture.minFilter = MinFilter::LinearMipmapLinear; // it is incomplete, and stays so
    EXPECT_THAT(needed(scene), Not(Contains(raised)));
}

TEST(EmittedUnits, HaveAllMatricesInAFrameWhereOneMoves) {
    Scene scene = defaultScene();
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].matrix = {{.op = MatrixOp::Scale, .amount = {3, 1, 1}}};
    const auto inFrame = [&] {
        const std::vector<std::string> lines = needed(scene);
        const auto frame = std::ranges::find_if(
            lines, [](const std::string& line) { return line.starts_with("static void draw("); });
        return std::find(frame, lines.end(), "glScalef(3.0f, 1.0f, 1.0f);") != lines.end();
    };
    EXPECT_FALSE(inFrame());
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .rate = {1, 0, 0}}};
    EXPECT_TRUE(inFrame());
    // A matrix that is loaded replaces a moving one.
    scene.passes[0].units[0].matrix.push_back({.op = MatrixOp::Load});
    EXPECT_FALSE(inFrame());
    EXPECT_THAT(needed(scene), Not(Contains(HasSubstr("seconds"))));
}

/// The calls between glMatrixMode(GL_TEXTURE) and glMatrixMode(GL_MODELVIEW).
std::vector<std::string> textureCalls(const Scene& scene) {
    std::vector<std::string> calls;
    bool isTexture = false;
    for (const std::string& line : needed(scene)) {
        if (line.starts_with("glMatrixMode("))
            isTexture = line == "glMatrixMode(GL_TEXTURE);";
        else if (isTexture)
            calls.push_back(line);
    }
    return calls;
}

TEST(EmittedMatrices, ArePushedAndPoppedAroundModels) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Scale, .amount = {3, 1, 1}}};
    scene.models[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
    EXPECT_THAT(textureCalls(scene),
                ElementsAre("glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);", "glPushMatrix();",
                            "glTranslatef(0.5f, 0.0f, 0.0f);", "glPopMatrix();",
                            StartsWith("glTranslatef(0.0f, 0.0f, 0.0f); /*"))); // for the second model
    scene.models[0].pushMatrix = false;
    EXPECT_THAT(textureCalls(scene), ElementsAre("glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);",
                                                 "glTranslatef(0.5f, 0.0f, 0.0f);"));
    scene.models[0].units[0].matrix = {{.op = MatrixOp::Load}};
    EXPECT_THAT(textureCalls(scene), Contains("glLoadMatrixf(unit0Model0Matrix0);"));
    scene.models[0].visible = false;
    EXPECT_THAT(textureCalls(scene), ElementsAre("glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);"));
}

TEST(EmittedMatrices, ArePushedKeptOrLoadedByPasses) {
    Scene scene = defaultScene();
    scene.passes.resize(3, scene.passes[0]);
    const auto unit = [&](std::size_t pass) -> Unit& { return scene.passes[pass].units[0]; };
    unit(0).matrix = {{.op = MatrixOp::Scale, .amount = {3, 1, 1}}};
    unit(1).matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0, 0}}};
    unit(1).matrixStart = MatrixStart::Push;
    unit(2).matrixStart = MatrixStart::Keep;
    EXPECT_THAT(textureCalls(scene),
                ElementsAre("glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);", "glPushMatrix();",
                            "glTranslatef(0.5f, 0.0f, 0.0f);", "glPopMatrix();",
                            StartsWith("glTranslatef(0.0f, 0.0f, 0.0f); /*")));
    // A pass that draws nothing has no calls: what it would leave is made again.
    scene.models.push_back({.visible = false});
    scene.passes[0].models = {2};
    EXPECT_THAT(textureCalls(scene),
                ElementsAre("glPushMatrix();", "glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);",
                            "glTranslatef(0.5f, 0.0f, 0.0f);", "glPopMatrix();", "glLoadIdentity();",
                            "glScalef(3.0f, 1.0f, 1.0f);"));
}

TEST(EmittedMatrices, OfOnePassBeginEachFrameAnew) {
    Scene scene = defaultScene();
    Unit& unit = scene.passes[0].units[0];
    unit.matrix = {{.op = MatrixOp::Scale, .amount = {3, 1, 1}}};
    unit.matrixStart = MatrixStart::Keep;
    EXPECT_THAT(textureCalls(scene), ElementsAre("glLoadIdentity();", "glScalef(3.0f, 1.0f, 1.0f);"));
    unit.matrixStart = MatrixStart::Push; // glPopMatrix leaves the identity to the next frame
    EXPECT_THAT(textureCalls(scene),
                ElementsAre("glPushMatrix();", "glScalef(3.0f, 1.0f, 1.0f);", "glPopMatrix();"));
}

TEST(EmittedUnits, WriteAMatrixColumnByColumn) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Multiply}};
    const std::vector<std::string> lines = needed(scene);
    const auto array = std::ranges::find(lines, "const GLfloat unit0Matrix0[] = {");
    ASSERT_GT(lines.end() - array, 6);
    EXPECT_THAT(std::vector(array + 1, array + 6),
                ElementsAre("1.0f, 0.0f, 0.0f, 0.0f,", "0.0f, 1.0f, 0.0f, 0.0f,", "0.0f, 0.0f, 1.0f, 0.0f,",
                            "0.0f, 0.0f, 0.0f, 1.0f,", "};"));
}

TEST(EmittedPrograms, SayWhatTheyAreAndHowTheyAreCompiled) {
    emit::TextureCodes codes;
    const emit::ProgramOptions options{
        .title = "Wrap */ \"it\"", .about = "Two sentences.", .source = "my wrap.c", .selfContained = true};
    const auto lines = emit::program(emit::Flavour::Fixed, defaultScene(), {}, options, codes);
    ASSERT_TRUE(lines);
    const std::string text = textOf(*lines, false);
    EXPECT_THAT(
        text,
        StartsWith(
            "/* Wrap * / \"it\"\n * Two sentences.\n * cc 'my wrap.c' -o 'my wrap' -lglfw -lGL -lm */\n"));
    EXPECT_THAT(text, HasSubstr(R"("Wrap */ \"it\"")"));
}

TEST(EmittedPrograms, AreCompiledByTheirNames) {
    const auto compiled = [](const std::string& file) {
        emit::TextureCodes codes;
        const emit::ProgramOptions options{.source = file, .selfContained = true};
        const auto lines = emit::program(emit::Flavour::Fixed, defaultScene(), {}, options, codes);
        return textOf(lines->at(1));
    };
    EXPECT_EQ(compiled("wrap-1.c"), " * cc wrap-1.c -o wrap-1 -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("-x.c"), " * cc ./-x.c -o ./-x -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("$(ls).c"), " * cc '$(ls).c' -o '$(ls)' -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("it's.c"), R"( * cc 'it'\''s.c' -o 'it'\''s' -lglfw -lGL -lm */)");
    EXPECT_EQ(compiled(".c"), " * cc -x c .c -x none -o .c.out -lglfw -lGL -lm */");
    const std::string name(60, 'n');
    EXPECT_EQ(compiled(name + " " + name + ".c"),
              " * cc '" + name + " " + name + ".c' -o '" + name + " " + name + "' -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("demo"), " * cc -x c demo -x none -o demo.out -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("a.html"), " * cc -x c a.html -x none -o a.html.out -lglfw -lGL -lm */");
    EXPECT_EQ(compiled("a*/b\n.c"), " * cc a__b_.c -o a__b_ -lglfw -lGL -lm */");
}

TEST(EmittedPrograms, HaveAWordOnWhatALessonIsAbout) {
    emit::TextureCodes codes;
    const emit::ProgramOptions options{.explained = {"textures[0].minFilter"}};
    const auto lines = emit::program(emit::Flavour::Fixed, defaultScene(), {}, options, codes);
    ASSERT_TRUE(lines);
    const auto call = std::ranges::find_if(
        *lines, [](const Line& line) { return mentions(line, "textures[0].minFilter"); });
    ASSERT_NE(call, lines->end());
    EXPECT_THAT(textOf(*(call - 1)), StartsWith("    /* How a colour is found where a pixel covers more"));
}

TEST(EmittedPrograms, SayWhatALessonIsAboutAlsoWhereOpenGlStartsWithIt) {
    emit::TextureCodes codes;
    const emit::ProgramOptions options{.explained = {"textures[0].wrapS", "passes[0].units[0].envColor"}};
    const auto lines = emit::program(emit::Flavour::Fixed, defaultScene(), {}, options, codes);
    ASSERT_TRUE(lines);
    const std::string call = "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);";
    EXPECT_THAT(textOf(*lines, false), HasSubstr(call));
    EXPECT_THAT(textOf(*lines, false),
                HasSubstr("glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, unit0EnvColor);"));
    EXPECT_THAT(needed(defaultScene()), Not(Contains(call)));
}

TEST(EmittedPrograms, RefuseWhatTheyCantDraw) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::LightDepth;
    emit::TextureCodes codes;
    const auto lines = emit::program(emit::Flavour::Fixed, scene, {}, {}, codes);
    ASSERT_FALSE(lines);
    EXPECT_EQ(describe(lines.error()),
              "textures[0].internalFormat: programs support shadow maps in depth textures, not GL_RGBA");
    scene.textures[0].internalFormat = InternalFormat::DepthComponent24;
    EXPECT_THAT(needed(scene), Contains("drawShadowMap0();"));
}

TEST(EmittedPictures, AreDrawnBeforeTheWindow) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::Picture;
    scene.textures[0].mipmaps = MipPolicy::None;
    scene.passes.push_back(scene.passes[0]);
    scene.passes[0].picture = 1;
    scene.passes[0].units[0].enabled = false;
    const std::string text = textOf(programOf(scene), false);
    EXPECT_THAT(text, HasSubstr("glBindFramebuffer(GL_FRAMEBUFFER, picture0);"));
    EXPECT_LT(text.find("static void drawPicture0"), text.find("static void draw(int width"));
    scene.textures[0].pictureCall = PictureCall::CopyTexImage;
    scene.textures[0].internalFormat = InternalFormat::Luminance;
    EXPECT_THAT(needed(scene),
                Contains("glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 0, 0, width, height, 0);"));
}

// EXT_framebuffer_object, sections 4.4.3 and 4.4.4.
TEST(EmittedPictures, AreRefusedWhereAFramebufferCannotBeDrawnInto) {
    Scene scene = defaultScene();
    scene.textures[0].source = SourceKind::Picture;
    scene.textures[0].mipmaps = MipPolicy::None;
    scene.passes.push_back(scene.passes[0]);
    scene.passes[0].picture = 1;
    emit::TextureCodes codes;
    const auto refusal = [&] {
        const auto lines = emit::program(emit::Flavour::Fixed, scene, {}, {}, codes);
        return lines ? std::string() : describe(lines.error()).english();
    };
    EXPECT_EQ(refusal(),
              "textures[0].pictureCall: what a pass reads of the texture that it draws into is undefined; "
              "it can be copied");
    scene.passes[0].units[0].enabled = false;
    EXPECT_EQ(refusal(), "");
    scene.textures[0].internalFormat = InternalFormat::Luminance;
    EXPECT_EQ(refusal(),
              "textures[0].internalFormat: nothing can be drawn into a texture of GL_LUMINANCE; it can be "
              "copied");
    scene.textures[0].pictureCall = PictureCall::CopyTexImage;
    EXPECT_EQ(refusal(), "");
    scene.textures[0].preparation.resize(1);
    EXPECT_EQ(refusal(),
              "textures[0].preparation: programs show pictures of passes as they are drawn, without "
              "this");
}

/// Hidden parts cost nothing: while a number is dragged, the numbers of texels are not written.
TEST(EmittedPrograms, WriteNumbersOfTexelsWhenTheyAreRead) {
    Scene scene = defaultScene();
    scene.textures[0].pattern = Pattern::Brick;
    emit::TextureCodes codes;
    const auto dataOf = [&](float azimuth) {
        scene.view.azimuth = azimuth;
        std::vector<Line> lines = emit::program(emit::Flavour::Fixed, scene, {}, {}, codes).value();
        std::erase_if(lines, [](const Line& line) { return !line.data; });
        return lines;
    };
    const std::vector<Line> before = dataOf(10);
    const std::vector<Line> after = dataOf(20);
    ASSERT_FALSE(before.empty());
    ASSERT_TRUE(before[0].data->source);
    EXPECT_EQ(before[0].data->source, after[0].data->source);
    EXPECT_TRUE(readsAs(before[0], after[0]));
    EXPECT_EQ(before[0].data->text(), after[0].data->text());
    scene.textures[0].pattern = Pattern::Planet;
    EXPECT_FALSE(readsAs(before[0], dataOf(20)[0]));
}

TEST(EmittedLines, TellApartWhatStandsForTheSameValue) {
    Scene scene = defaultScene();
    scene.models[0].size = 2;
    std::vector<int> occurrences;
    for (const Line& line : programOf(scene)) {
        for (const Part& part : line.parts) {
            if (part.path == "models[0].size")
                occurrences.push_back(part.occurrence);
        }
    }
    EXPECT_THAT(occurrences, ElementsAre(0, 1, 2));
}

} // namespace
} // namespace texplorer::emit_test
