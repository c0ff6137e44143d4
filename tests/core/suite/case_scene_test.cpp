#include "tests/support/temp_dir.h"
#include "texplorer/suite/case_scene.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <fstream>

namespace texplorer::suite::case_scene_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Plan planFor(const std::string& entry, const std::filesystem::path& folder = {}) {
    Result<Suite> suite = parseSuite(fmt::format(R"({{"suite": 1, "name": "s", "cases": [{}]}})", entry));
    EXPECT_TRUE(suite) << describe(suite.error());
    suite->folder = folder;
    Result<Plan> plan = planOf({*std::move(suite)});
    EXPECT_TRUE(plan) << describe(plan.error());
    return *std::move(plan);
}

TEST(CaseScene, HasTheEditsOfItsEntryAndOfItsAxes) {
    const Plan plan = planFor(R"({"set": ["textures[0].wrapS=GL_CLAMP", "textures[0].wrapT=GL_CLAMP"],
                                  "axis": "textures[0].wrapS=GL_REPEAT,GL_MIRRORED_REPEAT"})");
    ASSERT_EQ(plan.cases.size(), 2U);
    const Result<CaseScene> scene = openScene(plan, plan.cases[1]);
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->scene.textures[0].wrapS, Wrap::MirroredRepeat);
    EXPECT_EQ(scene->scene.textures[0].wrapT, Wrap::Clamp);
}

TEST(CaseScene, OfALessonIsTheStepsWithItsImages) {
    const Plan plan = planFor(R"({"scene": {"lesson": "wrap", "step": 3, "reached": true}})");
    const Result<CaseScene> scene = openScene(plan, plan.cases[0]);
    ASSERT_TRUE(scene) << describe(scene.error());
    EXPECT_EQ(scene->scene.textures[0].wrapS, Wrap::ClampToEdge);
    EXPECT_EQ(scene->scene.textures[0].wrapT, Wrap::ClampToBorder);
}

struct Lacking {
    std::string scene;
    ErrorCode code;
    std::string said;
};

TEST(CaseScene, WhatThereIsNotIsSaid) {
    const test::TempDir folder;
    const std::array lacking{
        Lacking{R"("absent.json")", ErrorCode::NotFound, "absent.json"},
        Lacking{R"({"lesson": "absent"})", ErrorCode::NotFound, "absent"},
        Lacking{R"({"lesson": "wrap", "step": 99})", ErrorCode::OutOfRange, "the lesson has the steps 1 to"},
        Lacking{R"({"lesson": "wrap", "answer": 1})", ErrorCode::OutOfRange, "this step has 0 answers"},
        Lacking{R"({"lesson": "wrap", "reached": true})", ErrorCode::OutOfRange, "no picture to reach"},
    };
    for (const Lacking& each : lacking) {
        const Plan plan = planFor(fmt::format(R"({{"scene": {}}})", each.scene), folder.path());
        ASSERT_TRUE(plan.cases[0].problem) << each.scene;
        EXPECT_EQ(plan.cases[0].problem->code, each.code) << describe(*plan.cases[0].problem);
        EXPECT_THAT(describe(*plan.cases[0].problem), HasSubstr(each.said));
    }
}

TEST(CaseScene, GoldensAreThoseOfTheDriver) {
    const Plan plan = planFor(R"({"name": "a/b", "size": "1x1", "renderer": ["fixed", "shader"], "golden":
        {"*": ["g/{case}.png", "g/{picture}.png"], "llvmpipe*": "g/{case}@{driver}.png"}})");
    EXPECT_THAT(goldensOf(plan, plan.cases[0], "llvmpipe (LLVM 15.0.6, 256 bits)"),
                ElementsAre("g/a__b__fixed@1x1@llvmpipe.png"));
    EXPECT_THAT(goldensOf(plan, plan.cases[1], "softpipe"),
                ElementsAre("g/a__b__shader@1x1.png", "g/a__b__1x1.png"));
    const Plan reference = planFor(R"({"golden": "reference"})");
    EXPECT_THAT(goldensOf(reference, reference.cases[0], "softpipe"), IsEmpty());
}

TEST(CaseScene, ImagesStayWithinTheSuitesFolder) {
    const test::TempDir folder;
    std::filesystem::create_directories(folder / "suite/scenes");
    std::ofstream(folder / "suite/near.bmp") << "near";
    std::ofstream(folder / "far.bmp") << "far";
    std::filesystem::create_symlink("../../far.bmp", folder / "suite/scenes/link.bmp");
    const auto opened = [&](const std::string& file, const std::string& set = {}) {
        std::ofstream(folder / "suite/scenes/a.json")
            << fmt::format(R"({{"textures": [{{"source": "file", "file": "{}"}}]}})", file);
        const Plan plan = planFor(R"({"scene": "scenes/a.json")" + set + "}", folder / "suite");
        return openScene(plan, plan.cases[0]).map([](const CaseScene&) { return true; });
    };
    EXPECT_TRUE(opened("../near.bmp"));
    EXPECT_TRUE(opened("absent.bmp")) << "which is said where it is read";
    for (const std::string& file :
         {std::string("../../far.bmp"), (folder / "far.bmp").string(), std::string("link.bmp")}) {
        const Result<bool> refused = opened(file);
        ASSERT_FALSE(refused) << file;
        EXPECT_EQ(refused.error().code, ErrorCode::OutOfRange);
        EXPECT_THAT(describe(refused.error()), HasSubstr("expected a file within the suite's folder"));
    }
    EXPECT_FALSE(opened("../near.bmp", R"(, "set": "textures[0].file=../../far.bmp")"));
}

/// What changes an outcome changes the fingerprint, and nothing else does.
TEST(CaseScene, FingerprintsAreOfAllThatDecides) {
    const test::TempDir folder;
    std::filesystem::create_directory(folder / "golden");
    std::ofstream(folder / "a.json") << R"({"textures": [{"source": "file", "file": "t.bmp"}]})";
    std::ofstream(folder / "t.bmp") << "one";
    std::ofstream(folder / "golden/a__fixed@1x1.png") << "one";
    const auto fingerprint = [&](const std::string& more, std::string_view with = "v1",
                                 std::string_view driver = "d") {
        const Plan plan = planFor(R"({"scene": "a.json", "size": "1x1")" + more + "}", folder.path());
        return Fingerprints().of(plan, plan.cases[0], with, driver);
    };
    const std::string first = fingerprint("");
    EXPECT_EQ(first.size(), 32U);
    EXPECT_EQ(fingerprint(""), first);
    EXPECT_EQ(fingerprint(R"(, "seconds": 7)"), first);
    EXPECT_NE(fingerprint("", "v2"), first);
    EXPECT_NE(fingerprint("", "v1", "e"), first);
    EXPECT_NE(fingerprint(R"(, "tolerance": 5)"), first);
    EXPECT_NE(fingerprint(R"(, "time": 1)"), first);
    EXPECT_NE(fingerprint(R"(, "set": "textures[0].wrapS=GL_CLAMP")"), first);
    EXPECT_NE(fingerprint(R"(, "golden": "reference")"), first);
    EXPECT_NE(fingerprint(R"(, "mask": "t.bmp")"), first);
    std::ofstream(folder / "t.bmp") << "another";
    const std::string second = fingerprint("");
    EXPECT_NE(second, first);
    std::ofstream(folder / "golden/a__fixed@1x1.png") << "another";
    const std::string third = fingerprint("");
    EXPECT_NE(third, second);
    std::ofstream(folder / "a.json") << "{";
    EXPECT_NE(fingerprint(""), third);
}

} // namespace
} // namespace texplorer::suite::case_scene_test
