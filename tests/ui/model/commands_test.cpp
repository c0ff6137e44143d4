#include "app/ui/model/commands.h"
#include "core/scene/animation.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <gmock/gmock.h>

#include <sstream>

namespace texplorer::ui::commands_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> calls(const Scene& scene) {
    std::vector<std::string> texts;
    for (const Command& each : commandsOf(scene)) {
        if (each.kind == Command::Kind::Call)
            texts.push_back(each.text);
    }
    return texts;
}

const Command* find(const std::vector<Command>& commands, std::string_view path) {
    for (const Command& each : commands) {
        if (each.path == path)
            return &each;
    }
    return nullptr;
}

TEST(Commands, CarryTheValues) {
    Scene scene = defaultScene();
    scene.textures[0].wrapS = Wrap::MirroredRepeat;
    scene.textures[0].borderColor = {1, 0, 0.5F, 1};
    EXPECT_THAT(calls(scene),
                Contains("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);"));
    EXPECT_THAT(calls(scene),
                Contains("glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, {1, 0, 0.5, 1});"));
}

TEST(Commands, SayWhatDiffersFromTheInitialValue) {
    Scene scene = defaultScene();
    scene.textures[0].wrapT = Wrap::Clamp;
    const std::vector<Command> commands = commandsOf(scene);
    ASSERT_NE(find(commands, "textures[0].wrapT"), nullptr);
    EXPECT_TRUE(find(commands, "textures[0].wrapT")->changed);
    EXPECT_FALSE(find(commands, "textures[0].wrapS")->changed);
}

TEST(Commands, DisableWhatIsOffAndFillInTheirNeighbours) {
    Scene scene = defaultScene();
    scene.passes[0].alphaTest = false;
    scene.passes[0].alphaFunc = CompareFunc::Greater;
    scene.passes[0].alphaRef = 0.5F;
    EXPECT_THAT(calls(scene), Contains("glDisable(GL_ALPHA_TEST);"));
    EXPECT_THAT(calls(scene), Contains("glAlphaFunc(GL_GREATER, 0.5);").Times(1));
    EXPECT_THAT(calls(scene), Contains("glEnable(GL_DEPTH_TEST);"));
}

TEST(Commands, NameTheTargetThatTheTextureIsShownAs) {
    Scene scene = defaultScene();
    scene.textures[0].border = 1;
    const auto upload = [&](Target target) {
        scene.passes[0].units[0].target = target;
        for (const std::string& call : calls(scene)) {
            if (call.starts_with("glTexImage"))
                return call;
        }
        return std::string();
    };
    EXPECT_EQ(upload(Target::Texture1D),
              "glTexImage1D(GL_TEXTURE_1D, level, GL_RGBA, width, 1, format, GL_UNSIGNED_BYTE, pixels);");
    EXPECT_EQ(upload(Target::Texture2D),
              "glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, width, height, 1, format, "
              "GL_UNSIGNED_BYTE, pixels);");
    EXPECT_EQ(upload(Target::Texture3D),
              "glTexImage3D(GL_TEXTURE_3D, level, GL_RGBA, width, height, depth, 1, "
              "format, GL_UNSIGNED_BYTE, pixels);");
    EXPECT_EQ(upload(Target::CubeMap), "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, GL_RGBA, "
                                       "width, height, 1, format, GL_UNSIGNED_BYTE, pixels);");
    EXPECT_THAT(calls(scene),
                Contains("glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_REPEAT);"));
    EXPECT_THAT(calls(scene), Contains("glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_DONT_CARE);"));
    EXPECT_THAT(calls(scene), Contains(testing::StartsWith("glTexImage")).Times(1));
}

TEST(Commands, LeaveOutTheCoordinatesThatATargetHasNot) {
    Scene scene = defaultScene();
    const auto wraps = [&](Target target) {
        scene.passes[0].units[0].target = target;
        std::string letters;
        for (const std::string& call : calls(scene)) {
            if (const std::size_t at = call.find("GL_TEXTURE_WRAP_"); at != std::string::npos)
                letters += call[call.find(", GL_REPEAT") - 1];
        }
        return letters;
    };
    EXPECT_EQ(wraps(Target::Texture1D), "S");
    EXPECT_EQ(wraps(Target::Texture2D), "ST");
    EXPECT_EQ(wraps(Target::CubeMap), "ST");
    EXPECT_EQ(wraps(Target::Texture3D), "STR");
    EXPECT_THAT(calls(scene), Contains("glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_REPEAT);"));
}

/// OpenGL's two matrices, as calls change them; GLM does the arithmetic.
struct Matrices {
    double aspect;
    glm::dmat4 projection{0};
    glm::dmat4 modelView{0};
    glm::dmat4* current = nullptr;

    double number(const std::string& text) const {
        double product = 1;
        std::istringstream factors(text);
        for (std::string factor; std::getline(factors, factor, '*');)
            product *= factor.find("aspect") != std::string::npos ? aspect : std::stod(factor);
        return product;
    }
    void run(const std::string& call) {
        const std::size_t bracket = call.find('(');
        const std::string name = call.substr(0, bracket);
        std::istringstream inside(call.substr(bracket + 1, call.find(')') - bracket - 1));
        std::vector<std::string> words;
        for (std::string word; std::getline(inside, word, ',');)
            words.push_back(word);
        const auto at = [&](std::size_t i) { return number(words.at(i)); };
        if (name == "glMatrixMode")
            current = words.at(0) == "GL_PROJECTION" ? &projection : &modelView;
        else if (name == "glLoadIdentity")
            *current = glm::dmat4(1);
        else if (name == "gluPerspective")
            *current *= glm::perspective(glm::radians(at(0)), at(1), at(2), at(3));
        else if (name == "glOrtho")
            *current *= glm::ortho(at(0), at(1), at(2), at(3), at(4), at(5));
        else if (name == "glTranslatef")
            *current = glm::translate(*current, {at(0), at(1), at(2)});
        else if (name == "glRotatef")
            *current = glm::rotate(*current, glm::radians(at(0)), {at(1), at(2), at(3)});
    }
};

double farthest(const glm::dmat4& a, const glm::mat4& b) {
    double most = 0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row)
            most = std::max(most, std::abs(a[column][row] - double{b[column][row]}));
    }
    return most;
}

TEST(Commands, SetUpTheCameraThatIsDrawnWith) {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        for (const float azimuth : {-35.0F, 0.0F, 110.0F}) {
            Scene scene = defaultScene();
            scene.view = {azimuth, 18, 25, 7.5F, {1, -2, 0.25F}, projection, 50, {}, {}};
            Matrices made{1.6};
            for (const Command& each : commandsOf(scene)) {
                if (each.kind == Command::Kind::Call && each.path.starts_with("view."))
                    made.run(each.text);
            }
            EXPECT_LT(farthest(made.modelView, viewMatrix(scene.view)), 1e-5) << azimuth;
            EXPECT_LT(farthest(made.projection, projectionMatrix(scene.view, 1.6F)), 1e-5) << azimuth;
            EXPECT_THAT(calls(scene), Not(Contains(HasSubstr("--"))));
        }
    }
}

TEST(Commands, LeaveOutUnitsThatAreOff) {
    Scene scene = defaultScene();
    EXPECT_EQ(find(commandsOf(scene), "passes[0].units[1].envMode"), nullptr);
    scene.passes[0].units[1].enabled = true;
    EXPECT_NE(find(commandsOf(scene), "passes[0].units[1].envMode"), nullptr);
}

// A driver of OpenGL 2.1 doesn't know the name.
TEST(Commands, NameSeamlessCubeMapsWhereThereIsACubeMap) {
    Scene scene = defaultScene();
    scene.passes[0].seamlessCubeMap = true;
    EXPECT_THAT(calls(scene), Not(Contains(HasSubstr("SEAMLESS"))));
    scene.passes[0].units[0].target = Target::CubeMap;
    EXPECT_THAT(calls(scene), Contains("glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);"));
    scene.passes[0].seamlessCubeMap = false;
    EXPECT_THAT(calls(scene), Contains("glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);"));
}

// Fog that is off is switched off and no more; of the distances and the density only what its mode asks for.
TEST(Commands, SetOfFogWhatItsModeAsksFor) {
    Scene scene = defaultScene();
    Fog& fog = scene.passes[0].fog;
    fog = {.mode = FogMode::Linear, .density = 0.5F, .start = 2, .end = 7, .color = {1, 0.5F, 0, 1}};
    EXPECT_THAT(calls(scene), Contains("glDisable(GL_FOG);"));
    EXPECT_THAT(calls(scene), Not(Contains(HasSubstr("glFog"))));
    fog.enabled = true;
    const std::vector<std::string> linear = calls(scene);
    for (const char* call :
         {"glEnable(GL_FOG);", "glFogi(GL_FOG_MODE, GL_LINEAR);", "glFogf(GL_FOG_START, 2);",
          "glFogf(GL_FOG_END, 7);", "glFogfv(GL_FOG_COLOR, {1, 0.5, 0, 1});"})
        EXPECT_THAT(linear, Contains(call));
    EXPECT_THAT(linear, Not(Contains(HasSubstr("GL_FOG_DENSITY"))));
    fog.mode = FogMode::Exp2;
    const std::vector<std::string> squared = calls(scene);
    EXPECT_THAT(squared, Contains("glFogi(GL_FOG_MODE, GL_EXP2);"));
    EXPECT_THAT(squared, Contains("glFogf(GL_FOG_DENSITY, 0.5);"));
    EXPECT_THAT(squared, Not(Contains(HasSubstr("GL_FOG_START"))));
    EXPECT_THAT(squared, Not(Contains(HasSubstr("GL_FOG_END"))));
}

TEST(Commands, LeaveOutPassesThatAreOff) {
    Scene scene = defaultScene();
    scene.passes.push_back(scene.passes[0]);
    scene.passes[1].blend = true;
    EXPECT_THAT(calls(scene), Contains("glEnable(GL_BLEND);"));
    scene.passes[1].enabled = false;
    EXPECT_THAT(calls(scene), Not(Contains("glEnable(GL_BLEND);")));
    EXPECT_THAT(calls(scene), Contains("glDisable(GL_BLEND);"));

    scene.passes[0].units[0].target = Target::Texture3D;
    EXPECT_THAT(calls(scene), Contains(HasSubstr("glTexParameteri(GL_TEXTURE_3D, ")));
    std::swap(scene.passes[0].enabled, scene.passes[1].enabled);
    EXPECT_THAT(calls(scene), Not(Contains(HasSubstr("glTexParameteri(GL_TEXTURE_3D, "))));
}

TEST(Commands, ShowCombineUnderItsModeAlone) {
    Scene scene = defaultScene();
    scene.passes[0].units[0].combine.source1Rgb = CombineSource::Constant;
    const std::string call = "glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_CONSTANT);";
    EXPECT_THAT(calls(scene), Not(Contains(call)));
    scene.passes[0].units[0].envMode = EnvMode::Combine;
    EXPECT_THAT(calls(scene), Contains(call).Times(1));
    EXPECT_THAT(calls(scene), Contains("glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 1);"));
    EXPECT_TRUE(find(commandsOf(scene), "passes[0].units[0].combine.source1Rgb")->changed);
    EXPECT_FALSE(find(commandsOf(scene), "passes[0].units[0].combine.source0Rgb")->changed);
}

TEST(Commands, ShowGeneratedCoordinatesThatAreOn) {
    Scene scene = defaultScene();
    EXPECT_THAT(calls(scene), Not(Contains("glDisable(GL_TEXTURE_GEN_T);")));
    TexGen& t = scene.passes[0].units[0].texGenT;
    t.enabled = true;
    t.mode = TexGenMode::ObjectLinear;
    t.objectPlane = {0, 0, 1, 0};
    EXPECT_THAT(calls(scene), Contains("glEnable(GL_TEXTURE_GEN_T);"));
    EXPECT_THAT(calls(scene), Contains("glTexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);"));
    EXPECT_THAT(calls(scene), Contains("glTexGenfv(GL_T, GL_OBJECT_PLANE, {0, 0, 1, 0});"));
    EXPECT_EQ(find(commandsOf(scene), "passes[0].units[0].texGenS.mode"), nullptr);
}

TEST(WrapCall, BreaksAfterCommasAndKeepsNumbersTogether) {
    EXPECT_THAT(wrapCall("glEnable(GL_BLEND);", 40), ElementsAre("glEnable(GL_BLEND);"));
    EXPECT_THAT(wrapCall("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);", 40),
                ElementsAre("glTexParameteri(GL_TEXTURE_2D,", "    GL_TEXTURE_WRAP_S, GL_REPEAT);"));
    EXPECT_THAT(wrapCall("glLightfv(GL_LIGHT0, GL_AMBIENT, {0, 0, 0, 1});", 40),
                ElementsAre("glLightfv(GL_LIGHT0, GL_AMBIENT,", "    {0, 0, 0, 1});"));
    EXPECT_THAT(wrapCall(std::string(100, 'x'), 20), ElementsAre(std::string(100, 'x')));
}

TEST(WrapCall, LosesNothing) {
    const std::string call =
        "glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, {0.25, 0.5, 0.75, 1});";
    for (std::size_t columns = 0; columns < 100; ++columns) {
        std::string joined;
        for (const std::string& line : wrapCall(call, columns)) {
            const std::string piece = line.substr(std::min(line.find_first_not_of(' '), line.size()));
            joined += (joined.ends_with(',') ? " " : "") + piece;
        }
        EXPECT_EQ(joined, call) << columns;
    }
}

TEST(Commands, UploadEachLevelThatIsGiven) {
    Scene scene = defaultScene();
    scene.textures[0].mipmaps = MipPolicy::Given;
    scene.textures[0].levels.resize(2);
    const std::vector<std::string> all = calls(scene);
    EXPECT_THAT(all, Contains(HasSubstr("glTexImage2D(GL_TEXTURE_2D, 0, ")));
    EXPECT_THAT(all, Contains(HasSubstr("glTexImage2D(GL_TEXTURE_2D, 2, ")));
    EXPECT_THAT(all, Contains(HasSubstr("glTexImage2D(")).Times(3));
}

TEST(Commands, LeaveTheLastScalingToTheUpload) {
    Scene scene = defaultScene();
    scene.textures[0].preparation = {
        {.op = ImageOp::Invert}, {.op = ImageOp::Scale, .factor = {0.5F, 1, 1, 1}, .bias = {0, 0.25F, 0, 0}}};
    std::vector<std::string> around;
    for (const std::string& call : calls(scene)) {
        if (call.starts_with("glPixelTransferf") || call.starts_with("glTexImage"))
            around.push_back(call.substr(0, call.find(';')));
    }
    EXPECT_THAT(around,
                ElementsAre("glPixelTransferf(GL_RED_SCALE, 0.5)", "glPixelTransferf(GL_GREEN_BIAS, 0.25)",
                            HasSubstr("glTexImage2D"), "glPixelTransferf(GL_RED_SCALE, 1)",
                            "glPixelTransferf(GL_GREEN_BIAS, 0)"));
    std::swap(scene.textures[0].preparation[0], scene.textures[0].preparation[1]);
    EXPECT_THAT(calls(scene), Not(Contains(HasSubstr("glPixelTransfer")))) << "something is done after it";
}

} // namespace
} // namespace texplorer::ui::commands_test
