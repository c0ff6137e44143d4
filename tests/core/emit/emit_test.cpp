#include "core/base/file_io.h"
#include "core/emit/emit.h"
#include "core/scene/animation.h"
#include "core/scene/params/json.h"
#include "core/scene/params/params.h"
#include "tests/random/random_scene.h"
#include "tests/support/temp_dir.h"

#include <fmt/core.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace texplorer::emit_test {
namespace {

using emit::Line;
using emit::Part;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> linesOf(const Scene& scene, bool all) {
    std::vector<std::string> lines;
    std::istringstream text(textOf(emit::callsOf(scene), all));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}
std::vector<std::string> needed(const Scene& scene) {
    return linesOf(scene, false);
}
std::vector<std::string> all(const Scene& scene) {
    return linesOf(scene, true);
}

/// C functions with the calls of scenes, a file each, for the C compiler: real C, or it says so.
class CompiledCalls : public testing::Test {
protected:
    void add(const Scene& scene, const std::string& name) {
        const std::vector<Line> lines = emit::callsOf(scene);
        const std::filesystem::path file = folder_ / (name + ".c");
        std::ofstream(file) << emit::includes() << "void draw(void);\nvoid draw(void) {\n"
                            << textOf(lines, false) << "}\nvoid drawAll(void);\nvoid drawAll(void) {\n"
                            << textOf(lines, true) << "}\n";
        files_ += fmt::format(" '{}'", file.string());
    }
    void expectToCompile() const {
        const std::string command =
            TEXPLORER_C_COMPILER " -std=c99 -Wall -Wextra -Wpedantic -Werror -fsyntax-only" + files_;
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

// Names of files come from outside: none of them ends a comment or begins another line.
TEST_F(CompiledCalls, OfRandomScenesAreC) {
    const std::vector<std::string> files{"a.png", "*/ int broken; /*", "line\nbreak.png",
                                         "/*/ what?"
                                         "?/\\",
                                         "é\xff.dds"};
    for (int i = 0; i < 48; ++i)
        add(random::randomScene(7, i, files).scene, fmt::format("random{}", i));
    expectToCompile();
}

/// What a value of a line has to be.
std::string expectedText(const Scene& scene, const Part& part) {
    const Result<std::string> value = getParam(scene, part.path);
    if (!value)
        return "no such parameter: " + part.path;
    if (part.kind != Part::Kind::Number)
        return *value;
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
        const Scene scene = random::randomScene(11, i, {}).scene;
        int numbers = 0;
        for (const Line& line : emit::callsOf(scene)) {
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
                      "GLfloat texture0BorderColor[] = {1.0f, 0.0f, 0.5f, 1.0f};",
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

// What the pass before has left is set back, and what it has set already isn't set again.
TEST(EmittedCalls, OfALaterPassBeginWithTheStateOfTheOneBefore) {
    Scene scene = defaultScene();
    scene.passes[0].blend = true;
    scene.passes[0].units[0].envMode = EnvMode::Decal;
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].target = Target::Texture1D;
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].blend = false;
    scene.passes[1].units[0].envMode = EnvMode::Modulate;
    scene.passes[1].units[1].enabled = false;
    const std::vector<std::string> lines = needed(scene);
    const auto second = std::ranges::find(lines, "/* pass 1 */");
    ASSERT_NE(second, lines.end());
    const std::vector<std::string> first(lines.begin(), second);
    const std::vector<std::string> rest(second, lines.end());
    const std::string decal = "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);";
    EXPECT_THAT(first, Contains("glEnable(GL_BLEND);"));
    EXPECT_THAT(first, Contains(decal).Times(2));
    EXPECT_THAT(rest, Contains("glDisable(GL_BLEND);"));
    EXPECT_THAT(rest, Contains("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);"));
    EXPECT_THAT(rest, Contains("glDisable(GL_TEXTURE_1D);"));
    EXPECT_THAT(rest, Not(Contains("glEnable(GL_DEPTH_TEST);")));
    EXPECT_THAT(rest, Not(Contains("glEnable(GL_TEXTURE_2D);")));

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
    for (const Line& line : emit::callsOf(scene)) {
        if (textOf(line).starts_with("glAlphaFunc")) {
            EXPECT_TRUE(mentions(line, "passes[0].alphaFunc"));
            EXPECT_TRUE(mentions(line, "passes[0].alphaRef"));
        }
    }
}

TEST(EmittedTextures, NameTheTargetThatTheyAreShownAs) {
    Scene scene = defaultScene();
    scene.textures[0].border = 1;
    const auto upload = [&](Target target) {
        scene.passes[0].units[0].target = target;
        for (std::string line : needed(scene)) {
            line.erase(0, line.find_first_not_of(' '));
            if (line.starts_with("glTexImage"))
                return line;
        }
        return std::string();
    };
    EXPECT_EQ(upload(Target::Texture1D), "glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, texture0Width, 1, GL_RGBA, "
                                         "GL_UNSIGNED_BYTE, texture0Texels);");
    EXPECT_EQ(upload(Target::Texture3D),
              "glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, texture0Width, texture0Height, "
              "texture0Depth, 1, GL_RGBA, GL_UNSIGNED_BYTE, texture0Texels);");
    EXPECT_EQ(upload(Target::CubeMap), "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, "
                                       "texture0Width, texture0Height, 1, GL_RGBA, GL_UNSIGNED_BYTE, "
                                       "texture0Texels[face]);");
    EXPECT_THAT(all(scene), Contains("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_REPEAT);"));
}

// OpenGL binds a texture object to one target for good.
TEST(EmittedTextures, ShownOnTwoTargetsAreTwoObjects) {
    Scene scene = defaultScene();
    scene.passes[0].units[1] = scene.passes[0].units[0];
    scene.passes[0].units[1].target = Target::Texture1D;
    EXPECT_THAT(needed(scene),
                IsSupersetOf({"GLuint textures[2];", "glBindTexture(GL_TEXTURE_2D, textures[0]);",
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
    scene.textures[0].levels.resize(2);
    EXPECT_THAT(needed(scene), Contains(StartsWith("glTexImage2D(")).Times(3));
    EXPECT_THAT(needed(scene),
                Contains(HasSubstr("glTexImage2D(GL_TEXTURE_2D, 2, GL_RGBA, texture0Level2Width")));
}

TEST(EmittedTextures, LeaveTheLastScalingToTheUpload) {
    Scene scene = defaultScene();
    scene.textures[0].preparation = {
        {.op = ImageOp::Invert}, {.op = ImageOp::Scale, .factor = {0.5F, 1, 1, 1}, .bias = {0, 0.25F, 0, 0}}};
    std::vector<std::string> around;
    for (const std::string& line : needed(scene)) {
        if (line.starts_with("glPixelTransferf") || line.starts_with("glTexImage"))
            around.push_back(line.substr(0, line.find(';')));
    }
    EXPECT_THAT(around,
                ElementsAre("glPixelTransferf(GL_RED_SCALE, 0.5f)", "glPixelTransferf(GL_GREEN_BIAS, 0.25f)",
                            HasSubstr("glTexImage2D"), "glPixelTransferf(GL_RED_SCALE, 1.0f)",
                            "glPixelTransferf(GL_GREEN_BIAS, 0.0f)"));
    std::swap(scene.textures[0].preparation[0], scene.textures[0].preparation[1]);
    EXPECT_THAT(needed(scene), Not(Contains(HasSubstr("glPixelTransfer")))) << "something is done after it";
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
                                             "GLfloat fogColor[] = {1.0f, 0.5f, 0.0f, 1.0f};",
                                             "glFogfv(GL_FOG_COLOR, fogColor);"}));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("GL_FOG_DENSITY"))));
    fog.mode = FogMode::Exp2;
    EXPECT_THAT(needed(scene), Contains("glFogf(GL_FOG_DENSITY, 0.5f);"));
    EXPECT_THAT(all(scene), Not(Contains(HasSubstr("GL_FOG_START"))));
}

// A driver of OpenGL 2.1 doesn't know the name.
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

// OpenGL multiplies eye planes by the inverse of the modelview matrix, which is the camera's by then.
TEST(EmittedUnits, SetEyePlanesWhileTheMatrixIsTheIdentity) {
    Scene scene = defaultScene();
    TexGen& t = scene.passes[0].units[0].texGenT;
    EXPECT_THAT(needed(scene), Not(Contains(HasSubstr("TEXTURE_GEN"))));
    t.enabled = true;
    t.eyePlane = {0, 0, 1, 0};
    const std::vector<std::string> lines = needed(scene);
    const auto enable = std::ranges::find(lines, "glEnable(GL_TEXTURE_GEN_T);");
    ASSERT_GT(lines.end() - enable, 6);
    EXPECT_THAT(std::vector<std::string>(enable + 1, enable + 6),
                ElementsAre("glPushMatrix();", "glLoadIdentity();",
                            "GLfloat unit0TEyePlane[] = {0.0f, 0.0f, 1.0f, 0.0f};",
                            "glTexGenfv(GL_T, GL_EYE_PLANE, unit0TEyePlane);", "glPopMatrix();"));
    t.mode = TexGenMode::ObjectLinear;
    t.objectPlane = {0, 0, 2, 0};
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
    EXPECT_EQ(lines.front(), "GLfloat seconds = 0.0f; /* since the start */");
    const auto mode = std::ranges::find(lines, "glMatrixMode(GL_TEXTURE);");
    ASSERT_GT(lines.end() - mode, 6);
    EXPECT_THAT(std::vector<std::string>(mode + 1, mode + 6),
                ElementsAre("glLoadIdentity();", "glTranslatef(0.5f, 0.5f, 0.0f);",
                            "glRotatef(30.0f + 15.0f * seconds, 0.0f, 0.0f, 1.0f);",
                            "glTranslatef(-0.5f, -0.5f, 0.0f);", "glMatrixMode(GL_MODELVIEW);"));
}

TEST(EmittedModels, AreDrawnWithGluVertexByVertexOrFromArrays) {
    const auto of = [](Model model, Unit second = {}) {
        Scene scene = defaultScene();
        scene.models = {std::move(model)};
        scene.passes[0].units[1] = second;
        return needed(scene);
    };
    EXPECT_THAT(of({.shape = Shape::Sphere, .slices = 9, .stacks = 7}),
                Contains("gluSphere(quadric, 1.0, 9, 7);"));
    EXPECT_THAT(of({.shape = Shape::Cylinder, .slices = 9, .stacks = 7, .topRadius = 0}),
                Contains("gluCylinder(quadric, 1.0, 0.0, 2.0, 9, 7);"));
    EXPECT_THAT(of({.shape = Shape::PartialDisk, .innerRadius = 0.5F, .startAngle = 10, .sweepAngle = 90}),
                Contains("gluPartialDisk(quadric, 0.5, 1.0, 32, 16, 10.0, 90.0);"));
    EXPECT_THAT(of({.shape = Shape::Sphere}, {.enabled = true}), Not(Contains(HasSubstr("gluSphere"))))
        << "GLU has coordinates for unit 0 alone";
    EXPECT_THAT(of({.shape = Shape::Cube}), Contains(HasSubstr("glVertex3f(")).Times(24));
    EXPECT_THAT(
        of({.shape = Shape::Quad}, {.enabled = true}),
        Contains(
            "    glMultiTexCoord2f(GL_TEXTURE0, 1.0f, 0.0f); glMultiTexCoord2f(GL_TEXTURE1, 1.0f, 0.0f); "
            "glVertex3f(1.0f, -1.0f, 0.0f);"));
    EXPECT_THAT(of({.shape = Shape::Teapot}),
                Contains("glDrawElements(GL_TRIANGLES, model0IndexCount, GL_UNSIGNED_INT, model0Indices);"));
    Model lines{.shape = Shape::Mesh, .lineWidth = 3};
    lines.mesh.primitive = Primitive::LineStrip;
    lines.mesh.positions.resize(5);
    EXPECT_THAT(of(lines), IsSupersetOf({"glLineWidth(3.0f);", "glBegin(GL_LINE_STRIP);"}));
    lines.mesh.indices = {0, 1, 99, 2};
    EXPECT_THAT(of(lines),
                IsSupersetOf({"const GLuint model0Indices[] = {0, 1, 2};",
                              "glDrawElements(GL_LINE_STRIP, 3, GL_UNSIGNED_INT, model0Indices);"}));
}

// However many vertices there are, the text stays one that can be read, and made in every frame.
TEST(EmittedModels, AreBounded) {
    Scene scene = defaultScene();
    Model points{.shape = Shape::Mesh};
    points.mesh.primitive = Primitive::Points;
    points.mesh.positions.resize(emit::mostWrittenVertices);
    scene.models = {points};
    EXPECT_THAT(needed(scene),
                Contains(HasSubstr("glVertex3f(")).Times(static_cast<int>(emit::mostWrittenVertices)));
    scene.models[0].mesh.positions.resize(maxMeshVertices);
    scene.models[0].texCoords[0].resize(maxMeshVertices);
    EXPECT_LT(all(scene).size(), 200U);
    EXPECT_THAT(needed(scene), Contains("extern const GLfloat model0Positions[][3];"));
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
    EXPECT_THAT(set, ElementsAre("glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32.0f);",
                                 "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 5.0f);",
                                 "glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32.0f);"));
}

/// OpenGL's matrices, as calls change them; GLM does the arithmetic.
class Matrices {
public:
    explicit Matrices(double aspect)
        : aspect_(aspect) {}

    void run(const Line& line) {
        const std::string text = textOf(line);
        const std::size_t bracket = text.find('(');
        if (bracket == std::string::npos || !text.starts_with("gl"))
            return;
        const std::string name = text.substr(0, bracket);
        std::istringstream inside(text.substr(bracket + 1, text.rfind(')') - bracket - 1));
        words_.clear();
        for (std::string word; std::getline(inside, word, ',');)
            words_.push_back(word);
        if (name == "glMatrixMode")
            current_ = words_.at(0) == "GL_PROJECTION" ? &projection
                       : words_.at(0) == "GL_TEXTURE"  ? &texture
                                                       : &modelView;
        else if (name == "glLoadIdentity")
            *current_ = glm::dmat4(1);
        else if (name == "glPushMatrix")
            stack_.push_back(*current_);
        else if (name == "glPopMatrix") {
            *current_ = stack_.back();
            stack_.pop_back();
        } else if (name == "gluPerspective")
            *current_ *= glm::perspective(glm::radians(at(0)), at(1), at(2), at(3));
        else if (name == "glOrtho")
            *current_ *= glm::ortho(at(0), at(1), at(2), at(3), at(4), at(5));
        else if (name == "glTranslatef")
            *current_ = glm::translate(*current_, {at(0), at(1), at(2)});
        else if (name == "glRotatef")
            *current_ = glm::rotate(*current_, glm::radians(at(0)), {at(1), at(2), at(3)});
        else if (name == "glScalef")
            *current_ = glm::scale(*current_, {at(0), at(1), at(2)});
        else if (name == "glBegin")
            drawn.push_back(modelView);
    }

    glm::dmat4 projection{1};
    glm::dmat4 modelView{1};
    glm::dmat4 texture{1};
    std::vector<glm::dmat4> drawn; ///< the matrix of each glBegin

private:
    [[nodiscard]] double at(std::size_t i) const {
        double product = 1;
        std::istringstream factors(words_.at(i));
        for (std::string factor; std::getline(factors, factor, '*');)
            product *= factor.find("-aspect") != std::string::npos  ? -aspect_
                       : factor.find("aspect") != std::string::npos ? aspect_
                                                                    : std::stod(factor);
        return product;
    }

    double aspect_;
    std::vector<std::string> words_;
    std::vector<glm::dmat4> stack_;
    glm::dmat4* current_ = &modelView;
};

double farthest(const glm::dmat4& a, const glm::mat4& b) {
    double most = 0;
    for (int i = 0; i < 16; ++i)
        most = std::max(most, std::abs(a[i / 4][i % 4] - double{b[i / 4][i % 4]}));
    return most;
}

TEST(EmittedCamera, IsTheOneThatIsDrawnWith) {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        for (const float azimuth : {-35.0F, 0.0F, 110.0F}) {
            Scene scene = defaultScene();
            scene.models.resize(1);
            scene.view = {azimuth, 18, 25, 7.5F, {1, -2, 0.25F}, projection, 50, {}, {}};
            for (const bool everything : {false, true}) {
                Matrices made(1.6);
                for (const Line& line : emit::callsOf(scene)) {
                    if (everything || line.needed)
                        made.run(line);
                }
                ASSERT_EQ(made.drawn.size(), 1U);
                EXPECT_LT(farthest(made.drawn[0], modelViewMatrix(scene.view, scene.models[0], 0)), 1e-5);
                EXPECT_LT(farthest(made.projection, projectionMatrix(scene.view, 1.6F)), 1e-5) << azimuth;
                EXPECT_THAT(all(scene), Not(Contains(HasSubstr("--"))));
            }
        }
    }
}

TEST(EmittedModels, ArePlacedAsTheyAreDrawn) {
    for (const EnumRow& order : rotationOrderRows) {
        for (const EnumRow& attachment : attachmentRows) {
            Scene scene = defaultScene();
            Model model;
            model.position = {1, -2, 0.5F};
            model.rotation = {10, 20, -35};
            model.rotationOrder = static_cast<RotationOrder>(order.value);
            model.attachment = static_cast<Attachment>(attachment.value);
            model.size = 1.5F;
            model.scale = {1, 0.5F, 2};
            scene.models = {model};
            Matrices made(1);
            for (const Line& line : emit::callsOf(scene)) {
                if (line.needed)
                    made.run(line);
            }
            ASSERT_EQ(made.drawn.size(), 1U);
            EXPECT_LT(farthest(made.drawn[0], modelViewMatrix(scene.view, model, 0)), 1e-5F)
                << order.name << ", " << attachment.name;
        }
    }
}

TEST(EmittedLines, TellApartWhatStandsForTheSameValue) {
    Scene scene = defaultScene();
    scene.models[0].size = 2;
    std::vector<int> occurrences;
    for (const Line& line : emit::callsOf(scene)) {
        for (const Part& part : line.parts) {
            if (part.path == "models[0].size")
                occurrences.push_back(part.occurrence);
        }
    }
    EXPECT_THAT(occurrences, ElementsAre(0, 1, 2));
}

} // namespace
} // namespace texplorer::emit_test
