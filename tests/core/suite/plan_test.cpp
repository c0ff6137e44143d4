#include "tests/support/temp_dir.h"
#include "texplorer/suite/plan.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <fstream>
#include <limits>
#include <set>

namespace texplorer::suite::plan_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Suite suiteOf(const std::string& entries) {
    Result<Suite> suite = parseSuite(fmt::format(R"({{"suite": 1, "name": "s", "cases": [{}]}})", entries));
    EXPECT_TRUE(suite) << describe(suite.error());
    return suite ? *std::move(suite) : Suite{};
}

std::vector<std::string> namesOf(const Result<Plan>& plan) {
    EXPECT_TRUE(plan) << describe(plan.error());
    std::vector<std::string> names;
    for (const Case& each : plan ? plan->cases : std::vector<Case>())
        names.push_back(each.name);
    return names;
}

TEST(Plan, ACaseIsAPictureOfTheDefaultScene) {
    const Result<Plan> plan = planOf({suiteOf("{}")});
    EXPECT_THAT(namesOf(plan), ElementsAre("default/fixed@512x512"));
    EXPECT_EQ(plan->cases[0].file, "default__fixed@512x512");
    EXPECT_EQ(plan->cases[0].pictureName, "default__512x512");
}

TEST(Plan, AxesRenderersSizesAndTimesAreMultiplied) {
    const Result<Plan> plan =
        planOf({suiteOf(R"({"name": "n", "renderer": ["fixed", "shader"], "size": ["8x8", "9x9"],
        "time": [0, 0.5], "axis": ["textures[0].wrapS=GL_REPEAT,GL_CLAMP", "textures[0].magFilter=*"]})")});
    const std::vector<std::string> names = namesOf(plan);
    ASSERT_EQ(names.size(), 32U);
    EXPECT_EQ(names[0], "n/wrapS=GL_REPEAT/magFilter=GL_NEAREST/fixed@8x8@0s");
    EXPECT_EQ(names[1], "n/wrapS=GL_REPEAT/magFilter=GL_NEAREST/fixed@8x8@0.5s");
    EXPECT_EQ(names[31], "n/wrapS=GL_CLAMP/magFilter=GL_LINEAR/shader@9x9@0.5s");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 32U);
    EXPECT_THAT(plan->cases[31].edits, ElementsAre(edit::Set{"textures[0].wrapS", "GL_CLAMP"},
                                                   edit::Set{"textures[0].magFilter", "GL_LINEAR"}));
    EXPECT_EQ(plan->cases[31].renderer, RendererKind::Shader);
    EXPECT_EQ(plan->cases[31].time, 0.5);
}

TEST(Plan, NamesComeFromScenes) {
    const test::TempDir folder;
    std::filesystem::create_directory(folder / "scenes");
    std::ofstream(folder / "scenes/bricks.json") << "{}";
    Suite suite = suiteOf(R"({"scene": "scenes/bricks.json", "size": "1x1"},
        {"scene": {"example": "checker"}, "size": "1x1"},
        {"scene": {"lesson": "wrap", "step": 2, "answer": 1}, "size": "1x1"},
        {"name": "both", "scene": [{"inline": {}}, {"example": "marble"}], "size": "1x1"})");
    suite.folder = folder.path();
    EXPECT_THAT(namesOf(planOf({suite})),
                ElementsAre("bricks/fixed@1x1", "checker/fixed@1x1", "wrap-2-answer-1/fixed@1x1",
                            "both/inline/fixed@1x1", "both/marble/fixed@1x1"));
}

TEST(Plan, TheReferenceIsNotHeldAgainstItself) {
    const Result<Plan> plan =
        planOf({suiteOf(R"({"golden": "reference"})")}, {.renderers = {RendererKind::Reference}});
    ASSERT_FALSE(plan);
    EXPECT_THAT(describe(plan.error()), testing::HasSubstr("it is compared with itself"));
    EXPECT_TRUE(planOf({suiteOf("{}")}, {.renderers = {RendererKind::Reference}}));
}

TEST(Plan, SeveralSuitesStandBeforeTheNamesOfTheirCases) {
    Suite second = suiteOf("{}");
    second.name = "sub/t";
    const Result<Plan> plan = planOf({suiteOf("{}"), second});
    EXPECT_THAT(namesOf(plan), ElementsAre("s/default/fixed@512x512", "sub/t/default/fixed@512x512"));
    EXPECT_EQ(plan->cases[1].goldenName, "default__fixed@512x512"); // as where it is the only one
}

TEST(Plan, AxesWithOneKeyHaveTheirPaths) {
    const Result<Plan> plan =
        planOf({suiteOf(R"({"axis": ["models[0].size=1", "models[1].size=2"], "size": "1x1"})")});
    EXPECT_THAT(namesOf(plan), ElementsAre("default/models[0].size=1/models[1].size=2/fixed@1x1"));
}

/// Ten to the sixth: 100 scenes' worth of times x 100 sizes x 10 x 10 choices.
TEST(Plan, AMillionCasesAreRefusedWithTheirNumber) {
    std::string times;
    std::string sizes;
    for (int i = 0; i < 100; ++i) {
        times += fmt::format("{}{}", i == 0 ? "" : ",", i);
        sizes += fmt::format("{}\"{}x1\"", i == 0 ? "" : ",", i + 1);
    }
    const Result<Plan> plan = planOf({suiteOf(fmt::format(
        R"({{"time": [{}], "size": [{}], "axis": ["models[0].size=1..2/10", "models[1].size=1..2/10"]}})",
        times, sizes))});
    ASSERT_FALSE(plan);
    EXPECT_EQ(plan.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(describe(plan.error()), "s: expected at most 100000 cases, found 1000000");
}

/// 256 to the eighth is 2 to the 64th, which no size has: the largest is said.
TEST(Plan, MoreCasesThanCanBeCountedAreRefusedToo) {
    std::string axes;
    for (const char* path : {"models[0].size", "models[0].position", "models[1].size", "view.distance",
                             "view.azimuth", "view.elevation", "view.fieldOfView", "textures[0].lodBias"}) {
        const bool isVector = std::string_view(path).ends_with("position");
        std::string values;
        for (int i = 0; i < 256; ++i)
            values += isVector ? fmt::format("{}0,0,{}", i == 0 ? "" : ";", i / 256.0) : std::string();
        axes += fmt::format("{}\"{}={}\"", axes.empty() ? "" : ",", path, isVector ? values : "1..2/256");
    }
    const Result<Plan> plan = planOf({suiteOf(fmt::format(R"({{"axis": [{}]}})", axes))});
    ASSERT_FALSE(plan);
    EXPECT_THAT(plan.error().message, HasSubstr(fmt::format("expected at most 100000 cases, found {}",
                                                            std::numeric_limits<std::size_t>::max())))
        << describe(plan.error());
}

TEST(Plan, ASceneThatIsMissingIsACaseOfItsOwn) {
    const test::TempDir folder;
    std::ofstream(folder / "bad.json") << "{";
    Suite suite = suiteOf(R"({"scene": ["absent.json", "bad.json"], "axis": "textures[0].wrapS=*"})");
    suite.folder = folder.path();
    const Result<Plan> plan = planOf({suite});
    EXPECT_THAT(namesOf(plan), ElementsAre("absent/fixed@512x512", "bad/fixed@512x512"));
    ASSERT_TRUE(plan->cases[0].problem && plan->cases[1].problem);
    EXPECT_EQ(plan->cases[0].problem->code, ErrorCode::NotFound);
    EXPECT_EQ(plan->cases[1].problem->code, ErrorCode::Malformed);
    EXPECT_THAT(plan->cases[1].problem->where.text(), HasSubstr("bad.json"));
}

struct Wrong {
    std::string entries;
    std::string said;
};

TEST(Plan, EditsAndAxesThatCantBeAreRefused) {
    const std::array wrongs{
        Wrong{R"({"set": "textures[0].wrapZ=1"})", "s: /cases/0/set/0: textures[0].wrapZ"},
        Wrong{R"({}, {"axis": "textures[0].wrapS=GL_REPAET"})", "s: /cases/1/axis/0"},
        Wrong{R"({"axis": ["textures[0].wrapS=*", "textures[0].wrapS=GL_CLAMP"]})",
              "expected each parameter in one axis"},
        Wrong{"{}, {}", "two cases are called \"default/fixed@512x512\""},
    };
    for (const Wrong& each : wrongs) {
        const Result<Plan> plan = planOf({suiteOf(each.entries)});
        ASSERT_FALSE(plan) << each.entries;
        EXPECT_THAT(describe(plan.error()), HasSubstr(each.said));
    }
}

TEST(Plan, OptionsChooseRenderersAndCases) {
    const std::string entry = R"({"axis": "textures[0].magFilter=*", "size": "1x1"})";
    EXPECT_THAT(
        namesOf(planOf({suiteOf(entry)}, {.renderers = {RendererKind::Reference}, .only = {"*LINEAR*"}})),
        ElementsAre("default/magFilter=GL_LINEAR/reference@1x1"));
    const Result<Plan> none = planOf({suiteOf(entry)}, {.renderers = {}, .only = {"*X*", "y"}});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().message, "no case is called \"*X*\", \"y\"");
}

TEST(Plan, NamesCantSteerATerminal) {
    EXPECT_THAT(namesOf(planOf({suiteOf(R"({"name": "a\nb\u001b[2J<script>", "size": "1x1"})")})),
                ElementsAre("a\\u000ab\\u001b[2J<script>/fixed@1x1"));
}

TEST(Plan, FingerprintsAreOfNamesInAnyOrder) {
    const Result<Plan> one = planOf({suiteOf(R"({"name": "a"}, {"name": "b"})")});
    const Result<Plan> two = planOf({suiteOf(R"({"name": "b"}, {"name": "a"})")});
    const Result<Plan> other = planOf({suiteOf(R"({"name": "a"}, {"name": "c"})")});
    EXPECT_EQ(fingerprintOf(*one), fingerprintOf(*two));
    EXPECT_NE(fingerprintOf(*one), fingerprintOf(*other));
}

} // namespace
} // namespace texplorer::suite::plan_test
