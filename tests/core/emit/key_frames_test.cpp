#include "tests/random/random_scene.h"
#include "texplorer/emit/emission.h"
#include "texplorer/emit/key_frames.h"
#include "texplorer/emit/program.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <random>
#include <span>
#include <sstream>

namespace texplorer::key_frames_test {
namespace {

using emit::Flavour;
using emit::Line;
using emit::Part;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

Result<std::vector<Line>> programOf(const Scene& scene, Flavour flavour = Flavour::Fixed) {
    emit::TextureCodes codes;
    return emit::program(flavour, scene, {}, {}, codes);
}

std::string textOf(const Scene& scene, Flavour flavour = Flavour::Fixed) {
    const auto lines = programOf(scene, flavour);
    return lines ? emit::textOf(*lines, false) : describe(lines.error()).english();
}

/// Without what they are indented by.
std::vector<std::string> linesOf(std::istringstream text) {
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line.substr(std::min(line.find_first_not_of(' '), line.size())));
    return lines;
}

/// Those of a function.
std::vector<std::string> bodyOf(const std::string& text, const std::string& head) {
    const std::size_t start = text.find(head);
    if (start == std::string::npos)
        return {"there is no " + head};
    return linesOf(std::istringstream(text.substr(start, text.find("\n}\n", start) - start)));
}

Scene sceneWith(std::vector<KeyFrame> keys) {
    Scene scene = defaultScene();
    scene.timeline.keys = std::move(keys);
    return scene;
}

const std::string init = "static void init(void)";
const std::string draw = "static void draw(int width, int height, double seconds)";

TEST(EmittedKeyFrames, AreATableAndAVariable) {
    const std::string text = textOf(sceneWith(
        {{0, "view.fieldOfView", "40", Easing::EaseIn}, {2, "view.fieldOfView", "70", Easing::Linear}}));
    EXPECT_THAT(text, HasSubstr("static const Key viewFieldOfViewKeys[] = {\n"
                                "    {0.0f, easeIn, {40.0f}},\n"
                                "    {2.0f, linear, {70.0f}},\n"
                                "};\n"));
    EXPECT_THAT(text, HasSubstr("\nstatic GLfloat viewFieldOfView;\n"));
    EXPECT_THAT(text, HasSubstr("viewFieldOfView = (GLfloat)track(viewFieldOfViewKeys, 2, seconds, 0);\n"));
    EXPECT_THAT(bodyOf(text, draw),
                IsSupersetOf({"animate(seconds);",
                              "gluPerspective(viewFieldOfView, aspect, distance / 50.0, farthest);"}));
    for (const char* unused : {"easeOut", "easeInOut", "hold", "Step", "step("})
        EXPECT_THAT(text, Not(HasSubstr(unused)));
}

// A scene stays as its last keys leave it, and so does its program.
TEST(EmittedKeyFrames, SayHowTheyBeginAgain) {
    const std::string text = textOf(sceneWith(
        {{0, "view.fieldOfView", "40", Easing::Linear}, {2.5F, "view.fieldOfView", "70", Easing::Linear}}));
    EXPECT_THAT(
        text,
        HasSubstr("draw(width, height, glfwGetTime()); /* fmod(glfwGetTime(), 2.5): again and again */"));
    Scene spins = defaultScene();
    spins.models[0].spin = {0, 30, 0};
    EXPECT_THAT(textOf(spins), HasSubstr("draw(width, height, glfwGetTime());\n"));
}

// The mouse goes on turning what the keys turn.
TEST(EmittedKeyFrames, OfTheCameraLeaveTheMouseItsPart) {
    const std::string text = textOf(sceneWith({{0, "view.distance", "8"},
                                               {2, "view.distance", "3"},
                                               {0, "view.azimuth", "0"},
                                               {2, "view.azimuth", "90"}}));
    EXPECT_THAT(text, HasSubstr("static GLfloat azimuth = 0.0f;"));
    EXPECT_THAT(text, HasSubstr("static GLfloat distance = 1.0f;"));
    EXPECT_THAT(text, HasSubstr("viewAzimuth = azimuth + (GLfloat)track(viewAzimuthKeys, 2, seconds, 0);"));
    EXPECT_THAT(text,
                HasSubstr("viewDistance = distance * (GLfloat)track(viewDistanceKeys, 2, seconds, 0);"));
    EXPECT_THAT(bodyOf(text, draw), IsSupersetOf({"glTranslatef(0.0f, 0.0f, -viewDistance);",
                                                  "glRotatef(-viewAzimuth, 0.0f, 1.0f, 0.0f);",
                                                  "glRotatef(elevation, 1.0f, 0.0f, 0.0f);"}));
}

TEST(EmittedKeyFrames, LeaveToInitWhatStaysAsItIs) {
    Scene scene = sceneWith({{0, "passes[0].units[0].envColor", "1,0,0,1"},
                             {2, "passes[0].units[0].envColor", "0,0,1,1"},
                             {0, "textures[0].wrapS", "GL_REPEAT"},
                             {1, "textures[0].wrapS", "GL_CLAMP"}});
    scene.passes[0].units[0].envMode = EnvMode::Blend;
    scene.textures[0].wrapT = Wrap::Clamp;
    const std::string text = textOf(scene);
    const std::string mode = "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BLEND);";
    const std::string color = "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, pass0Unit0EnvColor);";
    EXPECT_THAT(bodyOf(text, init), Contains(mode));
    EXPECT_THAT(bodyOf(text, init), Not(Contains(HasSubstr("ENV_COLOR"))));
    EXPECT_THAT(bodyOf(text, draw), Not(Contains(mode)));
    EXPECT_THAT(bodyOf(text, draw), Contains(color));
    const std::vector<std::string> load = bodyOf(text, "static void loadTexture0(void)");
    EXPECT_THAT(load, Contains("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);"));
    EXPECT_THAT(load, Not(Contains(HasSubstr("WRAP_S"))));
    EXPECT_THAT(bodyOf(text, draw),
                IsSupersetOf({"glBindTexture(GL_TEXTURE_2D, textures[0]);",
                              "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, texture0WrapS);"}));
    EXPECT_THAT(text, HasSubstr("static const Step texture0WrapSSteps[] = {\n"
                                "    {0.0f, GL_REPEAT},\n"
                                "    {1.0f, GL_CLAMP},\n"
                                "};\n"));
}

TEST(EmittedKeyFrames, SwitchOnAndOff) {
    const std::string text =
        textOf(sceneWith({{0, "passes[0].blend", "false"}, {1, "passes[0].blend", "true"}}));
    EXPECT_THAT(text, HasSubstr("    if (pass0Blend)\n"
                                "        glEnable(GL_BLEND);\n"
                                "    else\n"
                                "        glDisable(GL_BLEND);\n"));
    EXPECT_THAT(text, HasSubstr("pass0Blend = step(pass0BlendSteps, 2, seconds);"));
    EXPECT_THAT(bodyOf(text, init), Not(Contains(HasSubstr("GL_BLEND"))));
}

// The Commands tab makes no control of what a variable stands for.
TEST(EmittedKeyFrames, ArePlainText) {
    Scene scene = sceneWith({{0, "models[0].rotation", "0,0,0"}, {1, "models[0].rotation", "0,90,0"}});
    const auto lines = programOf(scene);
    ASSERT_TRUE(lines) << describe(lines.error());
    int found = 0;
    for (const Line& line : *lines) {
        for (const Part& part : line.parts) {
            if (part.path != "models[0].rotation")
                continue;
            EXPECT_EQ(part.kind, Part::Kind::Plain);
            EXPECT_THAT(part.text, HasSubstr("model0Rotation["));
            ++found;
        }
    }
    EXPECT_EQ(found, 3);
}

TEST(EmittedKeyFrames, ThatSayTheSameAreNone) {
    const std::string text =
        textOf(sceneWith({{0, "view.fieldOfView", "50"}, {2, "view.fieldOfView", "50"}}));
    EXPECT_THAT(text, HasSubstr("gluPerspective(50.0f, "));
    EXPECT_THAT(text, Not(HasSubstr("animate")));
}

TEST(EmittedKeyFrames, OfShadersAreUniforms) {
    Scene scene = sceneWith({{0, "light.position", "2,3,4,1"}, {2, "light.position", "-2,3,4,1"}});
    scene.passes[0].lighting = true;
    const std::string text = textOf(scene, Flavour::Glsl);
    const std::string call =
        "glUniform4f(glGetUniformLocation(program, \"lightPosition\"), lightPosition[0], "
        "lightPosition[1], lightPosition[2], lightPosition[3]);";
    EXPECT_THAT(bodyOf(text, draw), Contains(call));
    EXPECT_THAT(bodyOf(text, init), Not(Contains(HasSubstr("lightPosition"))));
    EXPECT_THAT(bodyOf(text, init), Contains(HasSubstr("lightDiffuse")));
}

struct RefusedCase {
    const char* name;
    Flavour flavour;
    std::vector<KeyFrame> keys;
    const char* path;
    const char* why;
};

TEST(EmittedKeyFrames, AreRefusedWhereTheProgramWouldBeAnother) {
    const std::vector<KeyFrame> shape{{0, "models[0].shape", "cube"}, {1, "models[0].shape", "sphere"}};
    const std::vector<KeyFrame> mode{{0, "passes[0].units[0].envMode", "GL_DECAL"},
                                     {1, "passes[0].units[0].envMode", "GL_ADD"}};
    const std::vector<KeyFrame> coordinate{{0, "models[0].texCoords0[3]", "0,0"},
                                           {1, "models[0].texCoords0[3]", "2,0"}};
    std::vector<KeyFrame> second{{0, "view.azimuth", "0"}, {1, "view.azimuth", "50"}};
    second.insert(second.end(), shape.begin(), shape.end());
    const RefusedCase cases[] = {
        {"shape", Flavour::Fixed, shape, "models[0].shape", "shapes are made only when the program starts"},
        {"the second parameter", Flavour::Fixed, second, "models[0].shape",
         "shapes are made only when the program starts"},
        {"a vertex", Flavour::Fixed, coordinate, "models[0].texCoords0[3]",
         "it is a fixed part of the program"},
        {"environment", Flavour::Glsl, mode, "passes[0].units[0].envMode",
         "its values need different shaders or calls"},
        {"slices",
         Flavour::Glsl,
         {{0, "models[1].slices", "8"}, {1, "models[1].slices", "9"}},
         "models[1].slices",
         "shapes are made only when the program starts"},
        {"format",
         Flavour::Fixed,
         {{0, "textures[0].internalFormat", "GL_RGB"}, {1, "textures[0].internalFormat", "GL_ALPHA"}},
         "textures[0].internalFormat",
         "texels are made only when the program starts"},
        {"visible",
         Flavour::Fixed,
         {{0, "models[0].visible", "true"}, {1, "models[0].visible", "false"}},
         "models[0].visible",
         "its values need different calls"},
        {"a light at infinity",
         Flavour::Glsl,
         {{0, "light.position", "0,0,1,0"}, {1, "light.position", "0,0,1,1"}},
         "light.position",
         "a directional light has other shaders"},
    };
    for (const RefusedCase& each : cases) {
        const auto lines = programOf(sceneWith(each.keys), each.flavour);
        ASSERT_FALSE(lines) << each.name;
        EXPECT_EQ(lines.error().where, each.path) << each.name;
        EXPECT_THAT(lines.error().message,
                    HasSubstr(fmt::format("can't animate this by key frames, because {}; texshot animate can",
                                          each.why)));
    }
    EXPECT_TRUE(programOf(sceneWith(mode)));
}

// The core profile has no GL_CLAMP: where only the nearest texel is read, GL_CLAMP_TO_EDGE is the same.
TEST(EmittedKeyFrames, AreRefusedWhereAnotherNameStandsForThem) {
    Scene scene = sceneWith({{0, "textures[0].wrapS", "GL_REPEAT"}, {1, "textures[0].wrapS", "GL_CLAMP"}});
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::Nearest;
    EXPECT_TRUE(programOf(scene));
    const auto lines = programOf(scene, Flavour::Glsl);
    ASSERT_FALSE(lines);
    EXPECT_EQ(lines.error().where, "textures[0].wrapS");
    scene.timeline.keys[1].value = "GL_CLAMP_TO_EDGE";
    EXPECT_TRUE(programOf(scene, Flavour::Glsl));
}

TEST(EmittedKeyFrames, AreRefusedWhereTooManyCombinationsDecide) {
    Scene scene = defaultScene();
    // Each of the four components is the least and the greatest at a key of its own: 8 values.
    for (const char* path : {"light.ambient", "light.diffuse", "light.modelAmbient", "light.specular"}) {
        for (int i = 0; i < 8; ++i) {
            glm::vec4 color(0.5F);
            color[i / 2] = static_cast<float>(i % 2);
            scene.timeline.keys.push_back({static_cast<float>(i), path,
                                           fmt::format("{},{},{},{}", color.r, color.g, color.b, color.a)});
        }
    }
    emit::KeyFrames keys(Flavour::Fixed, scene);
    EXPECT_TRUE(keys.decided(scene, {"light"}, [](const Scene&) { return true; }));
    EXPECT_EQ(keys.refused().path, "light.specular"); // 8 * 8 * 8 are 512
    EXPECT_EQ(keys.refused().why,
              "a part of the program depends on more than 1024 combinations of key frames");
}

TEST(EmittedKeyFrames, OfTheBaseLevelMoveUnlessTheDriverMakesLevels) {
    Scene scene = sceneWith({{0, "textures[0].baseLevel", "0"}, {1, "textures[0].baseLevel", "3"}});
    EXPECT_THAT(bodyOf(textOf(scene), draw),
                Contains("glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, texture0BaseLevel);"));
    scene.textures[0].mipmaps = MipPolicy::GenerateMipmap; // above the base level
    const auto lines = programOf(scene);
    ASSERT_FALSE(lines);
    EXPECT_EQ(lines.error().where, "textures[0].baseLevel");
}

// Mesa is given at least the base level, or it crashes: that isn't the number of the keys.
TEST(EmittedKeyFrames, AreRefusedWhereOpenGlIsGivenAnotherNumber) {
    Scene scene = sceneWith({{0, "textures[0].maxLevel", "1"}, {1, "textures[0].maxLevel", "2"}});
    EXPECT_TRUE(programOf(scene));
    scene.textures[0].baseLevel = 3;
    scene.textures[0].minFilter = MinFilter::Linear; // which reads the base level alone
    const auto lines = programOf(scene);
    ASSERT_FALSE(lines);
    EXPECT_EQ(lines.error().where, "textures[0].maxLevel");
}

// What each of these values needs is written once, whichever of them there is at a time.
TEST(EmittedKeyFrames, BringWhatAnyOfTheirValuesNeeds) {
    Scene scene = sceneWith({{0, "passes[0].units[0].envMode", "GL_MODULATE"},
                             {1, "passes[0].units[0].envMode", "GL_COMBINE"},
                             {0, "passes[0].units[0].texGenS.mode", "GL_EYE_LINEAR"},
                             {1, "passes[0].units[0].texGenS.mode", "GL_SPHERE_MAP"},
                             {2, "passes[0].units[0].texGenS.mode", "GL_OBJECT_LINEAR"}});
    Unit& unit = scene.passes[0].units[0];
    scene.passes[0].lighting = false;
    unit.combine.rgb = CombineRgb::Subtract;
    unit.texGenS = {true, TexGenMode::EyeLinear, {0, 3, 0, 0}, {0, 4, 0, 0}};
    const std::string text = textOf(scene);
    EXPECT_THAT(bodyOf(text, init),
                Contains(HasSubstr("glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_SUBTRACT);")));
    EXPECT_THAT(bodyOf(text, init), Contains(HasSubstr("glTexGenfv(GL_S, GL_OBJECT_PLANE,")));
    EXPECT_THAT(bodyOf(text, init), Contains(HasSubstr("glTexGenfv(GL_S, GL_EYE_PLANE,")));
    EXPECT_THAT(bodyOf(text, draw), Contains("glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, pass0Unit0TexGenSMode);"));
    EXPECT_THAT(text, HasSubstr("glNormal3f")); // for the sphere map
}

/// The scene with two or three keys for each parameter, with values of other scenes, but for those that a
/// program refuses.
Scene movingEverything(const Scene& scene, std::span<const Scene> others, Flavour flavour,
                       emit::TextureCodes& codes) {
    Scene moving = scene;
    Scene one = scene;
    forEachParam(scene, [&](const std::string& path, const ParamRow&, const Value&) {
        one.timeline.keys.clear();
        for (std::size_t i = 0; i < 3; ++i) {
            const Result<std::string> value = getParam(others[i], path);
            if (value && checkMovable(scene, path, *value))
                one.timeline.keys.push_back({static_cast<float>(i), path, *value});
        }
        if (emit::KeyFrames(flavour, one).refused().path.empty())
            moving.timeline.keys.insert(moving.timeline.keys.end(), one.timeline.keys.begin(),
                                        one.timeline.keys.end());
    });
    for (;;) {
        const auto program = emit::program(flavour, moving, {}, {}, codes);
        const auto isRefused = [&](const KeyFrame& key) { return key.path == program.error().where; };
        if (program || std::erase_if(moving.timeline.keys, isRefused) == 0)
            return moving;
    }
}

/// Each parameter somewhere between two of its keys, or at one.
Scene standingAtRandom(const emit::KeyFrames& keys, std::mt19937& random) {
    Scene scene = keys.standing();
    for (const auto& [path, param] : keys.params()) {
        if (param.row->kind == Kind::Bool) // which is on, where it can be
            continue;
        const auto& from = param.keys[random() % param.keys.size()];
        const auto& to = param.keys[random() % param.keys.size()];
        static_cast<void>(putBetween(scene, path, from.text, to.text, static_cast<double>(random() % 4) / 3));
    }
    return scene;
}

// A program is written of one standing scene, and right at all times if it is the same of every other.
TEST(EmittedKeyFrames, AreVariablesWhereverTheyStand) {
    std::vector<Scene> scenes;
    for (int number = 0; scenes.size() < 5; ++number) {
        const random::RandomScene made = random::randomScene(5, number, {});
        const bool hasShadows =
            std::ranges::find(made.scene.textures, SourceKind::LightDepth, &Texture::source) !=
            made.scene.textures.end(); // perhaps of a kind that programs don't have
        if (made.temper != random::Temper::Ordinary || hasShadows)
            continue;
        scenes.push_back(made.scene);
        scenes.back().timeline.keys.clear();
    }
    std::mt19937 random(1);
    std::size_t moved = 0;
    for (const Flavour flavour : {Flavour::Fixed, Flavour::Glsl}) {
        for (std::size_t i = 0; i + 3 < scenes.size(); ++i) {
            emit::TextureCodes codes;
            const Scene moving =
                movingEverything(scenes[i], std::span(scenes).subspan(i + 1, 3), flavour, codes);
            const auto program = emit::program(flavour, moving, {}, {}, codes);
            if (!program)
                continue; // a shadow map of a kind that programs don't have
            for (int stance = 0; stance < 6; ++stance) {
                emit::KeyFrames keys(flavour, moving);
                keys.standAt(standingAtRandom(keys, random));
                moved += keys.params().size();
                const auto other = flavour == Flavour::Glsl
                                       ? emit::glslProgram(keys.standing(), {}, {}, codes, keys)
                                       : emit::fixedProgram(keys.standing(), {}, {}, codes, keys);
                ASSERT_TRUE(other) << describe(other.error());
                EXPECT_EQ(keys.refused().path, "");
                const auto [line, otherLine] = std::ranges::mismatch(*program, *other, emit::readsAs);
                EXPECT_TRUE(line == program->end() && otherLine == other->end())
                    << "scene " << i << ": " << (line == program->end() ? "" : emit::textOf(*line));
            }
        }
    }
    EXPECT_GT(moved, 2000U);
}

TEST(EmittedKeyFrames, HaveVariablesNamedByTheirPath) {
    EXPECT_EQ(emit::variableOf("view.azimuth"), "viewAzimuth");
    EXPECT_EQ(emit::variableOf("passes[1].units[0].matrix[2].angle"), "pass1Unit0Matrix2Angle");
    EXPECT_EQ(emit::variableOf("models[12].material.diffuse"), "model12MaterialDiffuse");
}

} // namespace
} // namespace texplorer::key_frames_test
