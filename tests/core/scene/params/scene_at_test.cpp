#include "texplorer/scene/params/json.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_at.h"
#include "texplorer/scene/params/timeline_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace texplorer::scene_at_test {
namespace {

Scene sceneWith(std::vector<KeyFrame> keys) {
    Scene scene = defaultScene();
    scene.timeline.keys = std::move(keys);
    return scene;
}

TEST(SceneAt, IsTheSceneWhereNothingHasKeys) {
    const Scene scene = defaultScene();
    EXPECT_EQ(sceneAt(scene, 5), scene);
    EXPECT_EQ(&*StandingScene(scene, 5), &scene) << "not a copy";
}

TEST(SceneAt, MovesWhatHasKeysAndLeavesTheRest) {
    const Scene scene = sceneWith({{1, "view.azimuth", "10"},
                                   {3, "view.azimuth", "50", Easing::EaseIn},
                                   {5, "view.azimuth", "10"},
                                   {0, "textures[0].wrapS", "GL_REPEAT"},
                                   {2, "textures[0].wrapS", "GL_CLAMP_TO_EDGE"},
                                   {0, "view.background", "0,0,0,1"},
                                   {4, "view.background", "1,0.5,0,1"}});
    Scene expected = scene;
    expected.timeline = {};
    expected.textures[0].wrapS = Wrap::Repeat;
    const auto at = [&](double time, float azimuth, Wrap wrap, glm::vec4 background) {
        expected.view.azimuth = azimuth;
        expected.textures[0].wrapS = wrap;
        expected.view.background = background;
        EXPECT_EQ(sceneAt(scene, time), expected) << "at " << time;
    };
    at(-1, 10, Wrap::Repeat, {0, 0, 0, 1});
    at(0, 10, Wrap::Repeat, {0, 0, 0, 1});
    at(1, 10, Wrap::Repeat, {0.25F, 0.125F, 0, 1});
    at(1.999, 29.98F, Wrap::Repeat, {0.49975F, 0.249875F, 0, 1});
    at(2, 30, Wrap::ClampToEdge, {0.5F, 0.25F, 0, 1});
    at(4, 40, Wrap::ClampToEdge, {1, 0.5F, 0, 1}); // a quarter of the way back from 50
    at(5, 10, Wrap::ClampToEdge, {1, 0.5F, 0, 1});
    at(1e9, 10, Wrap::ClampToEdge, {1, 0.5F, 0, 1});
    EXPECT_EQ(sceneAt(sceneAt(scene, 2), 77), sceneAt(scene, 2)) << "it stands";
}

// At the time of a key its value is exact, regardless of the keys before and after it.
TEST(SceneAt, IsExactAtAKey) {
    const std::vector<float> times{0, 0.1F, 1.0F / 3, 0.7F, 5.3F, 3600};
    const std::vector<std::string> values{"0.1", "-0", "1e-40", "123.456", "-360", "359.99997"};
    std::vector<KeyFrame> keys;
    for (const EnumRow& easing : easingRows) {
        for (std::size_t i = 0; i < times.size(); ++i)
            keys.push_back({times[i], "view.azimuth", values[i], static_cast<Easing>(easing.value)});
        const Scene scene = sceneWith(keys);
        for (std::size_t i = 0; i < times.size(); ++i)
            EXPECT_EQ(getParam(sceneAt(scene, double{times[i]}), "view.azimuth").value(), values[i])
                << easing.name;
        keys.clear();
    }
}

TEST(SceneAt, MovesASingleVertex) {
    Scene scene =
        sceneWith({{0, "models[0].texCoords0[3]", "0,0"}, {2, "models[0].texCoords0[3]", "1,3,0,2"}});
    const TexCoords coords = sceneAt(scene, 1).models[0].texCoords[0];
    ASSERT_EQ(coords.size(), 24U) << "of a cube";
    EXPECT_EQ(coords[3], glm::vec4(0.5F, 1.5F, 0, 1.5F));
    EXPECT_EQ(coords[4], glm::vec4(0, 0, 0, 1)) << "as the mesh has it";
}

TEST(SceneAt, PassesOverKeysThatDoNotFit) {
    Scene expected = defaultScene();
    expected.view.azimuth = 7;
    EXPECT_EQ(sceneAt(sceneWith({{0, "models[77].size", "1"},
                                 {0, "nonsense", "1"},
                                 {0, "", ""},
                                 {0, "view.distance", "far"},
                                 {0, "view.distance", "1e30"},
                                 {0, "timeline[0].time", "5"},
                                 {0, "view.azimuth", "7"}}),
                      0),
              expected);
    const Scene nowhere = sceneWith({{0, "view.azimuth", "0"}, {1, "view.azimuth", "10"}});
    EXPECT_EQ(sceneAt(nowhere, -std::numeric_limits<double>::infinity()).view.azimuth, 0);
    EXPECT_EQ(sceneAt(nowhere, std::numeric_limits<double>::infinity()).view.azimuth, 10);
    EXPECT_TRUE(std::isfinite(sceneAt(nowhere, std::numeric_limits<double>::quiet_NaN()).view.azimuth));
}

TEST(Timeline, IsReadAndWrittenAsOneWouldWriteIt) {
    const std::string json = R"({"timeline": [
        {"path": "view.azimuth", "value": 10},
        {"time": 1.5, "path": "view.azimuth", "value": -0.5, "easing": "ease-in-out"},
        {"time": 2, "path": "view.background", "value": [0, 0.5, 1, 1]},
        {"time": 2, "path": "passes[0].blend", "value": true},
        {"time": 2, "path": "textures[0].wrapS", "value": "GL_CLAMP"},
        {"time": 2, "path": "models[0].name", "value": "1,5 \"x\""}]})";
    const auto scene = parseScene(json);
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_THAT(
        scene->timeline.keys,
        testing::ElementsAre(
            KeyFrame{0, "view.azimuth", "10"}, KeyFrame{1.5F, "view.azimuth", "-0.5", Easing::EaseInOut},
            KeyFrame{2, "view.background", "0,0.5,1,1"}, KeyFrame{2, "passes[0].blend", "true"},
            KeyFrame{2, "textures[0].wrapS", "GL_CLAMP"}, KeyFrame{2, "models[0].name", "1,5 \"x\""}));
    const std::string written = writeShortScene(*scene);
    EXPECT_EQ(parseScene(written).value(), *scene);
    EXPECT_EQ(written, R"({
  "version": 1,
  "timeline": [
    {
      "path": "view.azimuth",
      "value": 10
    },
    {
      "time": 1.5,
      "path": "view.azimuth",
      "value": -0.5,
      "easing": "ease-in-out"
    },
    {
      "time": 2,
      "path": "view.background",
      "value": [0, 0.5, 1, 1]
    },
    {
      "time": 2,
      "path": "passes[0].blend",
      "value": true
    },
    {
      "time": 2,
      "path": "textures[0].wrapS",
      "value": "GL_CLAMP"
    },
    {
      "time": 2,
      "path": "models[0].name",
      "value": "1,5 \"x\""
    }
  ]
}
)");
}

// Any text is the same after it was written to a file as a number.
TEST(Timeline, KeepsEveryText) {
    for (const char* text : {"",
                             "0",
                             "-0",
                             "5",
                             "05",
                             "5.0",
                             "0.10",
                             "1e+06",
                             "1e6",
                             "1000000",
                             "-3",
                             "1e-05",
                             "true",
                             "false",
                             "null",
                             "1,2",
                             "1, 2",
                             "1,",
                             ",",
                             "1,-0",
                             "1,16777217",
                             "1000000,2",
                             "inf",
                             "nan",
                             "1e999",
                             "0x10",
                             "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17",
                             "123456789012",
                             " 1",
                             "[1]",
                             "\"",
                             "+1",
                             ".5",
                             "3.4028235e+38"}) {
        const Scene scene = sceneWith({{1, "models[0].name", text}});
        const auto read = parseScene(writeScene(scene));
        ASSERT_TRUE(read) << text << describe(read.error());
        EXPECT_EQ(read->timeline.keys.front().value, text);
    }
}

TEST(Timeline, IsWrittenWithoutTheKeysThatDoNotFit) {
    Scene scene = sceneWith({{0, "models[77].size", "1"}, {0, "view.azimuth", "7"}});
    EXPECT_THAT(parseScene(writeScene(scene)).value().timeline.keys,
                testing::ElementsAre(KeyFrame{0, "view.azimuth", "7"}));
    scene = sceneWith({{0, "passes[0].units[0].texture", "9"}, {0, "view.azimuth", "7"}});
    EXPECT_THAT(parseScene(writeScene(scene)).value().timeline.keys,
                testing::ElementsAre(KeyFrame{0, "view.azimuth", "7"}));
}

struct Refused {
    const char* keys;
    const char* where;
    const char* message;
};

TEST(Timeline, SaysWhatIsWrongWithAKey) {
    for (
        const auto& [keys, where, message] :
        {Refused{R"({"path": "view.azimut", "value": 1})", "/timeline/0/path",
                 "view.azimut: no such parameter; did you mean \"azimuth\"?"},
         Refused{R"({"path": "azimuth", "value": 1})", "/timeline/0/path",
                 "azimuth: no such parameter; did you mean view.azimuth?"},
         Refused{R"({"path": "models[9].size", "value": 1})", "/timeline/0/path",
                 "models[9]: expected an existing index, counted from 0; the scene has 2"},
         Refused{R"({"value": 1})", "/timeline/0/path",
                 "expected the path of a parameter, as \"view.azimuth\", found none"},
         Refused{R"({"path": "view.azimuth"})", "/timeline/0/value",
                 "view.azimuth: expected a number from -360 to 360 deg, found \"\""},
         Refused{R"({"path": "view.azimuth", "value": "NaN"})", "/timeline/0/value",
                 "view.azimuth: expected a number from -360 to 360 deg, found \"NaN\""},
         Refused{R"({"path": "view.azimuth", "value": 361})", "/timeline/0/value",
                 "view.azimuth: expected a number from -360 to 360 deg, found 361"},
         Refused{R"({"path": "textures[0].wrapS", "value": "GL_REPAET"})", "/timeline/0/value",
                 "textures[0].wrapS: expected one of GL_REPEAT"},
         Refused{R"({"path": "view.azimuth", "value": 1, "time": 1e9})", "/timeline/0/time",
                 "expected a number from 0 to 3600 s, found 1e+09"},
         Refused{R"({"path": "view.azimuth", "value": 1, "time": -1})", "/timeline/0/time",
                 "expected a number from 0 to 3600 s, found -1"},
         Refused{R"({"path": "view.azimuth", "value": 1, "time": "1"})", "/timeline/0/time",
                 "expected a number from 0 to 3600 s, found \"1\""},
         Refused{
             R"({"path": "view.azimuth", "value": {}})", "/timeline/0/value",
             "expected a number between -3.4e38 and 3.4e38, an array of up to 16, true, false or UTF-8 text of at most 4096 "
             "bytes, found an object"},
         Refused{R"({"path": "view.azimuth", "value": null})", "/timeline/0/value",
                 "expected a number between"},
         Refused{R"({"path": "view.azimuth", "value": 1e300})", "/timeline/0/value",
                 "expected a number between"},
         Refused{R"({"path": "view.azimuth", "value": [[1]]})", "/timeline/0/value/0", "expected a number"},
         Refused{R"({"path": "view.azimuth", "value": 1, "easing": "bounce"})", "/timeline/0/easing",
                 "expected one of hold, linear"},
         Refused{R"({"path": "timeline[0].time", "value": 1})", "/timeline/0/path",
                 "timeline[0].time: a key can't move the timeline itself"},
         Refused{R"({"path": "passes[0].models", "value": "0,9"})", "/timeline/0/value",
                 "passes[0].models: there is no model 9, the scene has 2 models"},
         Refused{
             R"({"path": "view.azimuth", "value": 1}, {"time": 2, "path": "passes[0].units[0].texture", "value": 3})",
             "/timeline",
             "passes[0].units[0], at 2 s: an enabled unit needs an existing texture: it uses number 3, the "
             "scene has 1 texture"}}) {
        const auto scene = parseScene(std::string(R"({"timeline": [)") + keys + "]}");
        ASSERT_FALSE(scene) << keys;
        EXPECT_EQ(scene.error().where, where) << scene.error().message;
        EXPECT_THAT(scene.error().message, testing::StartsWith(message));
        EXPECT_LT(scene.error().message.english().size(), 400U);
    }
}

TEST(Timeline, HasALimit) {
    std::string keys;
    for (std::size_t i = 0; i <= maxKeyFrames; ++i)
        keys += std::string(i == 0 ? "" : ",") + R"({"path": "view.azimuth", "value": 1})";
    const auto scene = parseScene(R"({"timeline": [)" + keys + "]}");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().message, "expected at most 1024 elements, found more");
}

// A disabled unit may have a texture that does not exist.
TEST(Timeline, IsHeldTogetherAtEveryTime) {
    const auto keys = [](const char* off) {
        return std::vector<KeyFrame>{{0, "passes[0].units[0].enabled", "true"},
                                     {1, "passes[0].units[0].enabled", off},
                                     {2, "passes[0].units[0].texture", "5"},
                                     {0, "passes[0].units[0].texture", "0"}};
    };
    EXPECT_TRUE(checkTimeline(sceneWith(keys("false"))));
    EXPECT_FALSE(checkTimeline(sceneWith(keys("true"))));
}

TEST(Timeline, IsEditedByItsPaths) {
    Scene scene = sceneWith({{0, "view.azimuth", "7"}});
    EXPECT_TRUE(setParam(scene, "timeline[0].value", "8"));
    EXPECT_TRUE(setParam(scene, "timeline[0].easing", "hold"));
    EXPECT_EQ(sceneAt(scene, 0).view.azimuth, 8);
    EXPECT_FALSE(setParam(scene, "timeline[0].value", "far"));
    EXPECT_EQ(scene.timeline.keys[0].value, "8");
    EXPECT_FALSE(setParam(scene, "timeline[0].path", "view.azimut"));
    EXPECT_TRUE(setParam(scene, "timeline[0].path", "textures[0].wrapS")) << "its value comes next";
    EXPECT_TRUE(setParam(scene, "timeline[0].value", "GL_CLAMP"));
}

} // namespace
} // namespace texplorer::scene_at_test
