#include "tests/support/temp_dir.h"
#include "texplorer/suite/suite.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <fstream>
#include <set>
#include <sstream>

namespace texplorer::suite::suite_json_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string suiteOf(const std::string& entries, const std::string& more = {}) {
    return fmt::format(R"({{"suite": 1{}, "cases": [{}]}})", more, entries);
}

TEST(SuiteJson, IsReadAsItIsWritten) {
    const Result<Suite> suite = parseSuite(R"({
        "$schema": "x", "suite": 1, "name": "textures", "about": "A",
        "defaults": {"size": "64x32", "renderer": ["fixed", "shader"], "golden": "reference", "seconds": 5},
        "cases": [
            {"scene": "scenes/bricks.json", "set": "textures[0].wrapS=GL_CLAMP", "axis": ["a=*", "b=1,2"]},
            {"name": "n", "scene": [{"lesson": "wrap", "step": 3, "answer": 2}, {"example": "checker"}, "a.json"],
             "set": ["preset:seam", "x=a=b"], "size": ["1x1", "2x2"], "time": [0, 1.5], "renderer": "shader",
             "rule": "level-blend", "mask": "m.png"},
            {"scene": {"inline": {"version": 1}}, "golden": ["g/{case}.png", "g/{case}@{driver}.png"],
             "metric": "ssim", "tolerance": 0.25, "share": 0.125},
            {"golden": {"*": "a.png", "llvmpipe*": ["b.png", "{picture}.png"]}}
        ]})");
    ASSERT_TRUE(suite) << describe(suite.error());
    EXPECT_EQ(suite->name, "textures");
    EXPECT_EQ(suite->about, "A");
    ASSERT_EQ(suite->entries.size(), 4U);

    const Entry& first = suite->entries[0];
    EXPECT_THAT(first.scenes, ElementsAre(SceneSource{SceneFile{"scenes/bricks.json"}}));
    EXPECT_THAT(first.edits, ElementsAre(edit::Set{"textures[0].wrapS", "GL_CLAMP"}));
    EXPECT_THAT(first.axes, ElementsAre("a=*", "b=1,2"));
    EXPECT_THAT(first.settings.sizes, ElementsAre(PictureSize{64, 32}));
    EXPECT_THAT(first.settings.renderers, ElementsAre(RendererKind::Fixed, RendererKind::Shader));
    EXPECT_EQ(first.settings.golden, Golden{GoldenReference{}});
    EXPECT_EQ(first.settings.seconds, 5);

    const Entry& second = suite->entries[1];
    EXPECT_THAT(second.scenes,
                ElementsAre(SceneSource{SceneLesson{"wrap", 3, 2, false}},
                            SceneSource{SceneExample{"checker"}}, SceneSource{SceneFile{"a.json"}}));
    EXPECT_THAT(second.edits, ElementsAre(edit::ApplyPreset{"seam"}, edit::Set{"x", "a=b"}));
    EXPECT_THAT(second.settings.times, ElementsAre(0, 1.5));
    EXPECT_THAT(second.settings.renderers, ElementsAre(RendererKind::Shader));
    EXPECT_EQ(second.settings.golden, Golden{GoldenReference{"level-blend"}});
    EXPECT_EQ(second.settings.mask, "m.png");

    const Entry& third = suite->entries[2];
    EXPECT_EQ(third.settings.criterion.metric, Metric::Ssim);
    EXPECT_EQ(third.settings.criterion.tolerance, 0.25);
    EXPECT_EQ(third.settings.criterion.share, 0.125);
    EXPECT_EQ(third.settings.golden,
              (Golden{GoldenFiles{{{"*", {"g/{case}.png", "g/{case}@{driver}.png"}}}}}));

    // The glob that says most is the first, wherever it stood.
    EXPECT_EQ(suite->entries[3].settings.golden,
              (Golden{GoldenFiles{{{"llvmpipe*", {"b.png", "{picture}.png"}}, {"*", {"a.png"}}}}}));
}

TEST(SuiteJson, AnUnknownKeyIsAnsweredWithEveryKeyOnce) {
    const std::string said = parseSuite(suiteOf(R"({"zzzzzzzzzz": 1})")).error().message;
    constexpr std::string_view before = "unknown key; expected one of ";
    ASSERT_TRUE(said.starts_with(before)) << said;
    std::set<std::string> keys;
    std::istringstream list(said.substr(before.size()));
    for (std::string key; std::getline(list >> std::ws, key, ',');)
        EXPECT_TRUE(keys.insert(key).second) << key;
    EXPECT_GE(keys.size(), 10U) << said;
}

struct Wrong {
    std::string text;
    std::string where;
    std::string message;
};

TEST(SuiteJson, WhatIsWrongIsSaidWithItsPlace) {
    const std::array wrongs{
        Wrong{"", "line 1, column 1", "the file ends; expected a value"},
        Wrong{"[]", "", "expected an object, found a list"},
        Wrong{std::string("{\"suite\": 1, \"cases\": [{}]}\0, {", 31), "line 1, column 28",
              "expected JSON, found a NUL character"},
        Wrong{"{}", "", "expected the key \"suite\""},
        Wrong{R"({"suite": 2, "cases": [{}]})", "/suite", "expected version 1, found 2"},
        Wrong{R"({"suite": 1})", "", "expected the key \"cases\""},
        Wrong{suiteOf(""), "/cases", "expected a list of 1 to 10000, found 0"},
        Wrong{suiteOf(R"({"scenes": "a.json"})"), "/cases/0/scenes", "unknown key; did you mean \"scene\"?"},
        Wrong{suiteOf("{}", R"(, "defaults": {"toleranse": 1})"), "/defaults/toleranse",
              "unknown key; did you mean \"tolerance\"?"},
        Wrong{R"({"suite": 0, "cases": [{}]})", "/suite", "expected version 1, found 0"},
        Wrong{suiteOf(R"({"scene": "a.json", "scene": "b.json"})"), "/cases/0/scene",
              "expected each key once, found \"scene\" twice"},
        Wrong{suiteOf(R"({"set": [[1], {"a": {"b": 1}}], "size": "1x1"}, {"scene": {"a": [], "a": 1}})"),
              "/cases/1/scene/a", "found \"a\" twice"},
        Wrong{suiteOf(R"({"scene": "../a.json"})"), "/cases/0/scene", "it leads outside the folder"},
        Wrong{suiteOf(R"({"scene": "/etc/a.json"})"), "/cases/0/scene", "it is absolute"},
        Wrong{suiteOf(R"({"scene": "a\u0000.json"})"), "/cases/0/scene", "it has control characters"},
        Wrong{suiteOf(R"({"golden": "g/../../{case}.png"})"), "/cases/0/golden",
              "it leads outside the folder"},
        Wrong{suiteOf(R"({"golden": "{cases}.png"})"), "/cases/0/golden", "{case}, {picture} or {driver}"},
        Wrong{suiteOf(R"({"golden": "g.jpg"})"), "/cases/0/golden", "a name that ends in .png"},
        Wrong{suiteOf(R"({"golden": {}})"), "/cases/0/golden", "expected 1 to 16 drivers, found 0"},
        Wrong{suiteOf(R"({"size": "0x5"})"), "/cases/0/size", "a size of 1x1 to 16384x16384 pixels"},
        Wrong{suiteOf(R"({"size": ["9x9", "16385x1"]})"), "/cases/0/size/1", "found \"16385x1\""},
        Wrong{suiteOf(R"({"size": ["9x9", "9x9"]})"), "/cases/0/size/1", "expected each once"},
        Wrong{suiteOf(R"({"time": -1})"), "/cases/0/time", "seconds from 0 to"},
        Wrong{suiteOf(R"({"renderer": "shaders"})"), "/cases/0/renderer", "did you mean \"shader\"?"},
        Wrong{suiteOf(R"({"metric": "ssimm"})"), "/cases/0/metric", "did you mean \"ssim\"?"},
        Wrong{suiteOf(R"({"tolerance": 256})"), "/cases/0/tolerance", "a number from 0 to 255, found 256"},
        Wrong{suiteOf(R"({"golden": "reference", "renderer": ["fixed", "reference"]})"), "/cases/0",
              "it is compared with itself"},
        Wrong{suiteOf(R"({"golden": "reference", "tolerance": 2})"), "/cases/0/tolerance",
              "has no effect: the rule decides"},
        Wrong{suiteOf(R"({"metric": "ssim"})", R"(, "defaults": {"golden": "reference"})"), "/cases/0/metric",
              "has no effect: the rule decides"},
        Wrong{suiteOf("{}", R"(, "defaults": {"golden": "reference", "tolerance": 2})"),
              "/defaults/tolerance", "has no effect: a rule decides"},
        Wrong{suiteOf(R"({"pixelsPerDegree": 60})"), "/cases/0/pixelsPerDegree", "has no effect without"},
        Wrong{suiteOf(R"({"metric": "flip", "pixelsPerDegree": 513})"), "/cases/0/pixelsPerDegree",
              "a number from 1 to 512"},
        Wrong{suiteOf(R"({"share": "101%"})"), "/cases/0/share", "0% to 100%, found \"101%\""},
        Wrong{suiteOf(R"({"share": "0.1"})"), "/cases/0/share", "in percent"},
        Wrong{suiteOf(R"({"rgb": 1})"), "/cases/0/rgb", "true or false"},
        Wrong{suiteOf(R"({"share": 1.5})"), "/cases/0/share", "a number from 0 to 1"},
        Wrong{suiteOf(R"({"rule": "exact"})"), "/cases/0/rule", "a rule applies only to"},
        Wrong{suiteOf(R"({"golden": "reference", "rule": "exakt"})"), "/cases/0/rule",
              "did you mean \"exact\"?"},
        Wrong{suiteOf(R"({"set": "wrapS"})"), "/cases/0/set", "PATH=VALUE or preset:NAME"},
        Wrong{suiteOf(R"({"axis": "=1"})"), "/cases/0/axis", "PATH=VALUES"},
        Wrong{suiteOf(R"({"scene": {"lesson": "wrap", "step": 0}})"), "/cases/0/scene/step",
              "a whole number from 1"},
        Wrong{suiteOf(R"({"scene": {"lesson": "wrap", "answer": 1, "reached": true}})"), "/cases/0/scene",
              "expected one of answer and reached"},
        Wrong{suiteOf(R"({"scene": {}})"), "/cases/0/scene", "expected a file's name"},
        Wrong{suiteOf(R"({"scene": {"inline": {"vieew": 1}}})"), "/cases/0/scene/inline/vieew",
              "did you mean"},
        Wrong{suiteOf(R"({"seconds": 0})"), "/cases/0/seconds", "a number from 0.001"},
        Wrong{suiteOf(fmt::format(R"({{"name": "{}"}})", std::string(5000, 'n'))), "/cases/0/name",
              "expected at most 4096 bytes, found 5000"},
    };
    for (const Wrong& each : wrongs) {
        const Result<Suite> suite = parseSuite(each.text);
        ASSERT_FALSE(suite) << each.text;
        EXPECT_EQ(suite.error().where, each.where) << each.text;
        EXPECT_THAT(suite.error().message, HasSubstr(each.message)) << each.text;
    }
}

TEST(SuiteJson, WhatTheCommandLineTakesIsTaken) {
    const Result<Suite> suite = parseSuite(suiteOf(
        R"({"metric": "flip", "share": "0.1%", "rgb": true, "pixelsPerDegree": 30}, {"metric": "ssim"})",
        R"(, "defaults": {"rgb": true, "share": "50%", "tolerance": 9})"));
    ASSERT_TRUE(suite) << describe(suite.error());
    const Criterion& first = suite->entries[0].settings.criterion;
    EXPECT_EQ(first.metric, Metric::Flip);
    EXPECT_DOUBLE_EQ(first.share, 0.001);
    EXPECT_EQ(first.compared, Compared::Rgb);
    EXPECT_EQ(first.pixelsPerDegree, 30);
    EXPECT_EQ(first.tolerance, criterionOf(Metric::Flip).tolerance) << "9 was in another unit";
    const Criterion& second = suite->entries[1].settings.criterion;
    EXPECT_EQ(second.compared, Compared::Rgb);
    EXPECT_EQ(second.share, 0.5);
}

TEST(SuiteJson, AnExampleThatThereIsNotIsRefusedWithTheNearestOne) {
    const Result<Suite> suite = parseSuite(R"({"suite": 1, "cases": [{"scene": {"example": "cub"}}]})");
    ASSERT_FALSE(suite);
    EXPECT_EQ(describe(suite.error()),
              "/cases/0/scene/example: there is no example \"cub\"; did you mean \"cube\"?");
}

TEST(SuiteJson, TooMuchIsRefusedBeforeItIsRead) {
    const Result<Suite> large = parseSuite(std::string(maxSuiteBytes + 1, ' '));
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, ErrorCode::TooLarge);
    const Result<Suite> deep = parseSuite(std::string(100'000, '['));
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.error().code, ErrorCode::TooLarge);
}

/// A hundred thousand keys, of which each would be looked for among all others if they were kept in a list.
TEST(SuiteJson, AnObjectOfManyKeysIsReadInNoTime) {
    std::string text = R"({"suite": 1, "cases": [{"golden": {)";
    for (int i = 0; i < 100'000; ++i)
        text += fmt::format(R"({}"k{}": "g.png")", i == 0 ? "" : ", ", i);
    const Result<Suite> suite = parseSuite(text + "}}]}");
    ASSERT_FALSE(suite);
    EXPECT_EQ(suite.error().message, "expected 1 to 16 drivers, found 100000");
}

TEST(SuiteJson, AFilesNameAndFolderAreTheSuites) {
    const test::TempDir folder;
    std::ofstream(folder / "wrap.suite.json") << suiteOf("{}");
    const Result<Suite> suite = readSuite(folder / "wrap.suite.json");
    ASSERT_TRUE(suite) << describe(suite.error());
    EXPECT_EQ(suite->name, "wrap");
    EXPECT_EQ(suite->folder, folder.path());
    EXPECT_EQ(suite->entries[0].settings.golden, (Golden{GoldenFiles{{{"*", {"golden/{case}.png"}}}}}));
    std::ofstream(folder / "bad.suite.json") << suiteOf("3");
    const Result<Suite> bad = readSuite(folder / "bad.suite.json");
    ASSERT_FALSE(bad);
    EXPECT_EQ(describe(bad.error()),
              (folder / "bad.suite.json").string() + ": /cases/0: expected an object, found 3");
}

} // namespace
} // namespace texplorer::suite::suite_json_test
