// Calls that books use where the scene says so, and what takes their place in a program without them.

#include "texplorer/emit/program.h"
#include "texplorer/scene/params/params.h"

#include <gmock/gmock.h>

#include <sstream>

namespace texplorer::book_calls_test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<emit::Line> programOf(const Scene& scene, const emit::ProgramOptions& options = {},
                                  emit::Flavour flavour = emit::Flavour::Fixed) {
    emit::TextureCodes codes;
    const auto lines = emit::program(flavour, scene, {}, options, codes);
    EXPECT_TRUE(lines) << describe(lines.error());
    return lines.value_or(std::vector<emit::Line>{});
}

/// Lines without their indentation and the comment after a statement.
std::vector<std::string> statementsOf(const Scene& scene, const emit::ProgramOptions& options = {},
                                      emit::Flavour flavour = emit::Flavour::Fixed) {
    std::vector<std::string> lines;
    std::istringstream text(textOf(programOf(scene, options, flavour), false));
    for (std::string line; std::getline(text, line);) {
        line = line.substr(std::min(line.find_first_not_of(' '), line.size()));
        lines.push_back(line.substr(0, line.find(" /*")));
    }
    return lines;
}

/// The statements of the function that loads the first texture.
std::vector<std::string> loadingOf(const Scene& scene, emit::Flavour flavour = emit::Flavour::Fixed) {
    const std::vector<std::string> lines = statementsOf(scene, {}, flavour);
    const auto begin = std::ranges::find(lines, "static void loadTexture0(void)");
    const auto end = std::find(begin, lines.end(), "}");
    return begin == lines.end() ? std::vector<std::string>{} : std::vector(begin + 2, end);
}

Scene sceneWith(MipPolicy mipmaps) {
    Scene scene = defaultScene();
    scene.textures.resize(1);
    scene.textures[0] = {};
    scene.textures[0].mipmaps = mipmaps;
    scene.textures[0].baseLevel = 2;
    return scene;
}

TEST(MipmapCalls, StandBeforeTheBaseLevelIsSet) {
    constexpr const char* upload =
        "glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);";
    const auto around = [&](const char* first, const char* second) {
        return ElementsAre("glBindTexture(GL_TEXTURE_2D, textures[0]);", StartsWith("static GLubyte texels["),
                           StartsWith("checkerboard("), first, second,
                           "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);");
    };
    EXPECT_THAT(loadingOf(sceneWith(MipPolicy::GenerateMipmap)),
                around(upload, "glGenerateMipmap(GL_TEXTURE_2D);"));
    EXPECT_THAT(loadingOf(sceneWith(MipPolicy::OnUpload)),
                around("glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);", upload));
}

TEST(MipmapCalls, StandBehindTheParametersElsewhere) {
    Scene scene = sceneWith(MipPolicy::GenerateMipmap);
    scene.textures[0].baseLevel = 0;
    scene.textures[0].wrapS = Wrap::Clamp;
    EXPECT_THAT(loadingOf(scene),
                ElementsAre("glBindTexture(GL_TEXTURE_2D, textures[0]);",
                            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);",
                            StartsWith("static GLubyte texels["), StartsWith("checkerboard("),
                            StartsWith("glTexImage2D("), "glGenerateMipmap(GL_TEXTURE_2D);"));
}

// GLU uploads each level by its number: the base level may be set before.
TEST(MipmapCalls, OfGluHaveNoLevelAndNoBorder) {
    EXPECT_THAT(
        loadingOf(sceneWith(MipPolicy::Glu)),
        Contains("gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGBA, 64, 64, GL_RGBA, GL_UNSIGNED_BYTE, texels);"));
    Scene scene = sceneWith(MipPolicy::Glu);
    scene.passes[0].units[0].target = Target::CubeMap;
    EXPECT_THAT(loadingOf(scene),
                Contains(StartsWith("gluBuild2DMipmaps(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, ")));
    scene.passes[0].units[0].target = Target::Texture1D;
    EXPECT_THAT(loadingOf(scene),
                Contains(StartsWith("gluBuild1DMipmaps(GL_TEXTURE_1D, GL_RGBA, 64, GL_RGBA, ")));
}

// OpenGL 3.1 removed the parameter.
TEST(MipmapCalls, OfTheCoreProfileAreGlGenerateMipmap) {
    const std::vector<std::string> lines = loadingOf(sceneWith(MipPolicy::OnUpload), emit::Flavour::Glsl);
    EXPECT_THAT(lines, AllOf(Contains("glGenerateMipmap(GL_TEXTURE_2D);"),
                             Not(Contains(HasSubstr("GL_GENERATE_MIPMAP")))));
}

// Books of the core profile have no GLU.
TEST(MipmapCalls, OfGluAreALoopInTheCoreProfile) {
    EXPECT_EQ(loadingOf(sceneWith(MipPolicy::Glu), emit::Flavour::Glsl),
              loadingOf(sceneWith(MipPolicy::Generated), emit::Flavour::Glsl));
}

TEST(MipmapCalls, AreALoopInASelfContainedProgram) {
    const emit::ProgramOptions options{.selfContained = true};
    for (const MipPolicy policy : {MipPolicy::GenerateMipmap, MipPolicy::OnUpload, MipPolicy::Glu})
        EXPECT_EQ(statementsOf(sceneWith(policy), options),
                  statementsOf(sceneWith(MipPolicy::Generated), options))
            << rowOf(policy).name;
}

Scene sceneOf(Model model) {
    Scene scene = defaultScene();
    scene.models = {std::move(model)};
    return scene;
}

TEST(Quadrics, AreDrawnByGlu) {
    const auto of = [](Model model) { return statementsOf(sceneOf(std::move(model))); };
    const std::vector<std::string> sphere = of({.shape = Shape::Sphere, .slices = 9, .stacks = 7});
    const auto call = std::ranges::find(sphere, "gluSphere(quadric, 1.0, 9, 7);");
    ASSERT_NE(call, sphere.end());
    EXPECT_THAT(
        std::vector(call - 2, call + 2),
        ElementsAre("glPushMatrix();", "glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);", *call, "glPopMatrix();"));
    EXPECT_THAT(sphere, Contains("#define GLFW_INCLUDE_GLU"));
    EXPECT_THAT(sphere, Contains("gluPerspective(40.0f, aspect, distance / 50.0, farthest);"));
    EXPECT_THAT(sphere, Contains(HasSubstr(" -lglfw -lGLU -lGL -lm")));
    EXPECT_THAT(of({.shape = Shape::Cylinder, .slices = 9, .stacks = 7, .topRadius = 0.5F}),
                AllOf(Contains("glTranslatef(0.0f, 0.0f, -1.0f);"),
                      Contains("gluCylinder(quadric, 1.0, 0.5, 2.0, 9, 7);")));
    EXPECT_THAT(of({.shape = Shape::Disk, .innerRadius = 0.25F}),
                Contains("gluDisk(quadric, 0.25, 1.0, 32, 16);"));
    EXPECT_THAT(of({.shape = Shape::PartialDisk, .startAngle = 10, .sweepAngle = -400}),
                Contains("gluPartialDisk(quadric, 0.0, 1.0, 32, 16, 10.0, -400.0);"));
}

TEST(Quadrics, AreDrawnByTheProgramWhereGluCant) {
    const auto drawsItself = [](const Scene& scene, const emit::ProgramOptions& options = {}) {
        const std::vector<std::string> lines = statementsOf(scene, options);
        return testing::Value(lines,
                              AllOf(Contains("model0 = sphere(32, 16);"), Not(Contains(StartsWith("glu")))));
    };
    const Scene scene = sceneOf({.shape = Shape::Sphere});
    EXPECT_FALSE(drawsItself(scene));
    EXPECT_TRUE(drawsItself(scene, {.selfContained = true}));
    EXPECT_THAT(statementsOf(sceneOf({.shape = Shape::Sphere, .slices = 240})),
                Not(Contains(StartsWith("glu"))))
        << "GLU would draw 239";
    Scene generated = scene; // from positions, whose axes are others for GLU
    generated.passes[0].units[0].texGenS = {.enabled = true, .mode = TexGenMode::ObjectLinear};
    EXPECT_TRUE(drawsItself(generated));
    generated.passes[0].units[0].texGenS.mode = TexGenMode::EyeLinear;
    EXPECT_FALSE(drawsItself(generated));
    Scene two = scene; // glTexCoord sets the coordinates of unit 0 alone
    two.passes[0].units[1].enabled = true;
    EXPECT_TRUE(drawsItself(two));
    EXPECT_THAT(statementsOf(sceneOf({.shape = Shape::Torus})), Not(Contains(StartsWith("glu"))));
}

// A panel makes a control of each number that stands for a parameter.
TEST(Vertices, NameTheirParameters) {
    Model model{.shape = Shape::Mesh};
    model.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    model.mesh.normals = {{0, 0, 2}, {0.3F, 0.4F, 0}, {0, 0, 0}}; // GL_NORMALIZE makes their length 1
    Scene scene = sceneOf(std::move(model));
    scene.passes[0].lighting = true;
    std::vector<std::string> paths;
    for (const emit::Line& line : programOf(scene)) {
        for (const emit::Part& part : line.parts) {
            if (part.path.find("mesh.") != std::string::npos && part.component == 0)
                paths.push_back(part.path + " " + part.text);
        }
    }
    EXPECT_THAT(paths, ElementsAre("models[0].mesh.normals[0] 0.0f", "models[0].mesh.positions[0] 0.0f",
                                   "models[0].mesh.normals[1] 0.3f", "models[0].mesh.positions[1] 1.0f",
                                   "models[0].mesh.normals[2] 0.0f", "models[0].mesh.positions[2] 0.0f"));
}

TEST(Loaders, LoadBeforeTheFirstCall) {
    const auto of = [](emit::Loader loader) {
        return textOf(programOf(sceneOf({.shape = Shape::Sphere}), {.loader = loader}), false);
    };
    const std::string glew = of(emit::Loader::Glew);
    EXPECT_THAT(glew, HasSubstr(" -lglfw -lGLEW -lGLU -lGL -lm */"));
    EXPECT_LT(glew.find("#include <GL/glew.h>"), glew.find("#include <GLFW/glfw3.h>"));
    EXPECT_LT(glew.find("glfwMakeContextCurrent(window);"), glew.find("glewInit()"));
    EXPECT_LT(glew.find("glewInit()"), glew.rfind("init();"));
    EXPECT_THAT(glew, Not(HasSubstr("GL_GLEXT_PROTOTYPES")));
    const std::string glad = of(emit::Loader::Glad);
    EXPECT_THAT(glad,
                AllOf(HasSubstr("cc demo.c glad/src/gl.c -Iglad/include -o demo -lglfw -lGLU -lGL -lm */"),
                      HasSubstr("#include <glad/gl.h>"), HasSubstr("if (!gladLoadGL(glfwGetProcAddress)) {"),
                      Not(HasSubstr("GL_GLEXT_PROTOTYPES"))));
}

TEST(CMakeLists, NameWhatTheProgramNeeds) {
    const emit::ProgramOptions options{.source = "clean.c", .loader = emit::Loader::Glew};
    const std::string text = cmakeLists(programOf(sceneOf({.shape = Shape::Sphere}), options), options);
    EXPECT_THAT(text, AllOf(HasSubstr("add_executable(program clean.c)\n"), HasSubstr("OUTPUT_NAME clean)\n"),
                            HasSubstr("find_package(GLEW REQUIRED)\n"),
                            HasSubstr("glfw GLEW::GLEW OpenGL::GLU OpenGL::GL ")));
    const emit::ProgramOptions plain{.source = "cube.c", .selfContained = true};
    EXPECT_THAT(cmakeLists(programOf(sceneOf({.shape = Shape::Sphere}), plain), plain),
                AllOf(Not(HasSubstr("GLU")), Not(HasSubstr("GLEW"))));
}

} // namespace
} // namespace texplorer::book_calls_test
