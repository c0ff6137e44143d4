#include "tests/support/temp_dir.h"
#include "texplorer/codec/registry.h"
#include "texplorer/conform/judge.h"
#include "texplorer/files/file_io.h"
#include "texplorer/reference/draw.h"
#include "texplorer/suite/judge_case.h"
#include "texplorer/suite/record_json.h"
#include "texplorer/text/percent.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace texplorer::suite::judge_case_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A flat picture of one colour.
Image plain(int width, int height, std::array<int, 4> color) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(color[i % 4]);
    return image;
}

void setPixel(Image& image, int x, int y, std::array<int, 4> color) {
    std::ranges::transform(color, image.at(x, y).begin(),
                           [](int each) { return static_cast<std::byte>(each); });
}

void writePng(const std::filesystem::path& file, const Image& image) {
    const Result<Bytes> bytes = codecForExtension("x.png")->encode(textureOf(image, "PNG"), {});
    ASSERT_TRUE(bytes) << describe(bytes.error());
    ASSERT_TRUE(writeFileAtomically(file, *bytes));
}

class JudgeCase : public testing::Test {
protected:
    /// Plans one entry in the folder, and opens the scene of its first case.
    void plan(const std::string& entry) {
        Result<Suite> suite = parseSuite(fmt::format(R"({{"suite": 1, "name": "s", "cases": [{}]}})", entry));
        ASSERT_TRUE(suite) << describe(suite.error());
        suite->folder = folder_.path();
        Result<Plan> planned = planOf({*std::move(suite)});
        ASSERT_TRUE(planned) << describe(planned.error());
        plan_ = *std::move(planned);
        Result<CaseScene> scene = openScene(plan_, plan_.cases[0]);
        ASSERT_TRUE(scene) << describe(scene.error());
        scene_ = *std::move(scene);
    }

    JudgedCase judged(const Image& actual, const conform::Driver& driver = {}) {
        return judgeCase(plan_, plan_.cases[0], scene_, actual, driver);
    }

    Image drawnByReference(const conform::Driver& driver = {}) {
        const Case& of = plan_.cases[0];
        const Result<Frame> frame = reference::ReferenceRenderer().draw(
            {scene_.scene, scene_.images, of.time, of.size.width, of.size.height,
             anisotropyOf(plan_.settingsOf(of).golden, driver)});
        EXPECT_TRUE(frame) << describe(frame.error());
        return frame ? frame->image : Image{};
    }

    test::TempDir folder_;
    Plan plan_;
    CaseScene scene_;
};

constexpr std::array red{255, 0, 0, 255};
constexpr std::array darkRed{245, 0, 0, 255};

TEST_F(JudgeCase, WithoutAGoldenIsNew) {
    plan(R"({"size": "4x3", "golden": ["g/{case}.png", "{driver}.png"]})");
    const JudgedCase judged = this->judged(plain(4, 3, red));
    EXPECT_EQ(judged.record.state, State::New);
    EXPECT_EQ(judged.record.golden, "g/default__fixed@4x3.png");
    EXPECT_THAT(judged.record.sentence, HasSubstr("there is no golden yet"));
    EXPECT_FALSE(judged.expected);
}

TEST_F(JudgeCase, IsHeldAgainstItsGolden) {
    plan(R"({"size": "4x3", "golden": "a.png", "tolerance": 5})");
    writePng(folder_ / "a.png", plain(4, 3, red));
    Image actual = plain(4, 3, red);
    EXPECT_EQ(judged(actual).record.state, State::Passed);

    setPixel(actual, 1, 0, darkRed); // row 0 is the bottom one
    const JudgedCase failed = judged(actual, {.name = "d", .version = {}, .settings = {}});
    EXPECT_EQ(failed.record.state, State::Failed);
    EXPECT_EQ(failed.record.metric, "absolute");
    EXPECT_EQ(failed.record.tolerance, 5);
    EXPECT_DOUBLE_EQ(failed.record.shareOver, 1.0 / 12);
    ASSERT_TRUE(failed.record.worst);
    EXPECT_EQ(*failed.record.worst, (WorstPixel{1, 2, {255, 0, 0, 255}, {245, 0, 0, 255}}));
    EXPECT_EQ(failed.record.driver, "d");
    EXPECT_EQ(failed.record.name, "default/fixed@4x3");
    ASSERT_TRUE(failed.expected && failed.difference);
    EXPECT_EQ(*failed.expected, plain(4, 3, red));
    EXPECT_EQ(failed.difference->width, 4);
}

TEST_F(JudgeCase, AShareOfThePixelsMayBeOver) {
    plan(R"({"size": "4x3", "golden": "a.png", "tolerance": 5, "share": 0.1})");
    writePng(folder_ / "a.png", plain(4, 3, red));
    Image actual = plain(4, 3, red);
    setPixel(actual, 1, 1, darkRed);
    EXPECT_EQ(judged(actual).record.state, State::Passed);
    setPixel(actual, 2, 1, darkRed); // 2 of 12
    EXPECT_EQ(judged(actual).record.state, State::Failed);
}

TEST_F(JudgeCase, AnyOfSeveralGoldensWillDo) {
    plan(R"({"size": "2x2", "golden": ["a.png", "absent.png", "b.png"], "tolerance": 1})");
    writePng(folder_ / "a.png", plain(2, 2, {0, 0, 255, 255}));
    writePng(folder_ / "b.png", plain(2, 2, red));
    const JudgedCase passed = judged(plain(2, 2, red));
    EXPECT_EQ(passed.record.state, State::Passed);
    EXPECT_EQ(passed.record.golden, "b.png");
    Image actual = plain(2, 2, red);
    setPixel(actual, 0, 0, {0, 255, 0, 255});
    const JudgedCase failed = judged(actual);
    EXPECT_EQ(failed.record.state, State::Failed);
    EXPECT_EQ(failed.record.golden, "b.png") << "the nearer one";
}

TEST_F(JudgeCase, AnotherSizeIsSaid) {
    plan(R"({"size": "4x3", "golden": "a.png"})");
    writePng(folder_ / "a.png", plain(3, 4, red));
    const JudgedCase judged = this->judged(plain(4, 3, red));
    EXPECT_EQ(judged.record.state, State::Resized);
    ASSERT_TRUE(judged.expected);
    EXPECT_EQ(judged.expected->width, 3);
    EXPECT_FALSE(judged.difference);
    EXPECT_EQ(judged.record.metric, "") << "nothing was compared";
    EXPECT_FALSE(nlohmann::json::parse(journalLine(judged.record)).contains("score"));
}

TEST_F(JudgeCase, AGoldenThatIsNoPictureIsAnError) {
    plan(R"({"size": "4x3", "golden": "a.png"})");
    ASSERT_TRUE(writeFileAtomically(folder_ / "a.png", viewBytes("no picture")));
    const JudgedCase judged = this->judged(plain(4, 3, red));
    EXPECT_EQ(judged.record.state, State::Error);
    EXPECT_THAT(judged.record.sentence, HasSubstr("a.png"));
}

TEST_F(JudgeCase, AMaskLeavesPixelsOut) {
    plan(R"({"size": "2x2", "golden": "a.png", "mask": "mask.png"})");
    writePng(folder_ / "a.png", plain(2, 2, red));
    Image mask = plain(2, 2, {255, 255, 255, 255});
    setPixel(mask, 0, 1, {0, 0, 0, 255});
    writePng(folder_ / "mask.png", mask);
    Image actual = plain(2, 2, red);
    setPixel(actual, 0, 1, darkRed);
    EXPECT_EQ(judged(actual).record.state, State::Passed);
    setPixel(actual, 1, 1, darkRed);
    EXPECT_EQ(judged(actual).record.state, State::Failed);
    std::filesystem::remove(folder_ / "mask.png");
    EXPECT_EQ(judged(actual).record.state, State::Error);
}

TEST_F(JudgeCase, TheReferenceIsAGoldenThatNobodyHasToStore) {
    plan(R"({"size": "40x30", "time": 0.5, "golden": "reference"})");
    Image actual = drawnByReference();
    const JudgedCase passed = judged(actual);
    EXPECT_EQ(passed.record.state, State::Passed) << passed.record.sentence;
    EXPECT_EQ(passed.record.golden, "reference");
    EXPECT_THAT(passed.record.metric, HasSubstr("rule "));

    // 3 % of the pixels, which no rule but that of anisotropy would forgive
    for (int x = 0; x < 40; ++x)
        setPixel(actual, x, 12, {255, 0, 255, 255});
    setPixel(actual, 7, 13, {255, 0, 255, 255});
    const JudgedCase failed = judged(actual);
    EXPECT_EQ(failed.record.state, State::Failed) << failed.record.sentence;
    EXPECT_GT(failed.record.shareThatCounts(), 0.01);
    ASSERT_TRUE(failed.record.unexplained);
    EXPECT_GE(failed.record.over, *failed.record.unexplained);
    EXPECT_EQ(failed.record.pixels, 40U * 30);
    EXPECT_DOUBLE_EQ(failed.record.shareOver, static_cast<double>(failed.record.over) / (40 * 30));
    EXPECT_THAT(failed.record.sentence, HasSubstr(", and allows up to 1 %"));
    ASSERT_TRUE(failed.record.worst);
    EXPECT_THAT(failed.record.worst->actual, ElementsAre(255, 0, 255, 255));
    EXPECT_TRUE(failed.record.worst->y == 30 - 1 - 12 || failed.record.worst->y == 30 - 1 - 13);
    EXPECT_TRUE(failed.expected && failed.difference);
}

/// A driver whose anisotropy is compared.
conform::Driver mesa() {
    conform::Driver driver{"llvmpipe", {}, {}, {}};
    driver.facts.maxAnisotropy = 16;
    return driver;
}

// A driver may filter anisotropically as it likes, and still not draw another picture: 22 % of the pixels are
// too many, and so are 10 % that are off by more than half of what there is.
TEST_F(JudgeCase, ASquareIsNoMethodOfAnisotropy) {
    plan(R"({"scene": {"example": "fog"}, "size": "64x64", "golden": "reference"})");
    for (const int side : {30, 20}) {
        Image actual = drawnByReference(mesa());
        EXPECT_EQ(judged(actual, mesa()).record.state, State::Passed);
        for (int x = 0; x < side; ++x) {
            for (int y = 0; y < side; ++y)
                setPixel(actual, x, 63 - y, red);
        }
        const JudgedCase failed = judged(actual, mesa());
        EXPECT_EQ(failed.record.state, State::Failed) << failed.record.sentence;
        EXPECT_EQ(failed.record.metric, "rule ellipse");
        EXPECT_THAT(failed.record.sentence, HasSubstr("/255, of which the rule ellipse allows up to 5 %"));
    }
}

// "texshot shot --renderer reference" takes probes unless it is told otherwise.
TEST_F(JudgeCase, ADriverIsHeldToItsMethodAndAStoredPictureToWhatShotDraws) {
    plan(R"({"size": "40x30", "golden": "reference",
        "set": ["models[0].shape=floor", "textures[0].maxAnisotropy=8"]})");
    const auto drawnBy = [this](reference::AnisotropyMethod method) {
        const Result<Frame> frame =
            reference::drawReference({scene_.scene, scene_.images, 0, 40, 30, method});
        EXPECT_TRUE(frame) << describe(frame.error());
        return frame ? frame->image : Image{};
    };
    const std::string same = "it equals the reference's picture in every byte";
    EXPECT_EQ(judged(drawnBy(reference::AnisotropyMethod::Ellipse), mesa()).record.sentence, same);
    EXPECT_NE(judged(drawnBy(reference::AnisotropyMethod::Probes), mesa()).record.sentence, same);
    conform::Driver newer = mesa();
    newer.version = "4.5 (Compatibility Profile) Mesa 25.0.7-2";
    EXPECT_EQ(judged(drawnBy(reference::AnisotropyMethod::Line), newer).record.sentence, same);
    EXPECT_NE(judged(drawnBy(reference::AnisotropyMethod::Ellipse), newer).record.sentence, same);
    EXPECT_EQ(anisotropyOf(GoldenFiles{}, mesa()), reference::DrawRequest().anisotropy);
}

/// What a driver's precision may make of it: the reference's own picture with coordinates off by 1/128 of a
/// texel.
TEST_F(JudgeCase, ARuleGrantsWhatADriverMayDo) {
    const std::string entry = R"({"size": "128x128", "golden": "reference", "rule": "RULE",
        "set": ["textures[0].minFilter=GL_NEAREST", "textures[0].magFilter=GL_NEAREST"]})";
    const auto entryWith = [&](const std::string& rule) {
        return std::string(entry).replace(entry.find("RULE"), 4, rule);
    };
    plan(entryWith("auto"));
    scene_.scene = conform::movedByTexelError(scene_.scene, scene_.images).front();
    const Image actual = drawnByReference();
    plan(entryWith("auto"));
    EXPECT_NE(actual, drawnByReference());
    const JudgedCase granted = judged(actual);
    EXPECT_EQ(granted.record.state, State::Passed) << granted.record.sentence;
    EXPECT_EQ(granted.record.metric, "rule texel-edge");
    EXPECT_EQ(granted.record.unexplained, 0U);
    EXPECT_GT(granted.record.over, 0U);
    EXPECT_EQ(granted.record.sentence,
              fmt::format("{} pixels ({}) differ by more than 2/255 from the reference; the rule texel-edge "
                          "explains all of them",
                          granted.record.over, percentText(granted.record.shareOver)));
    plan(entryWith("exact"));
    EXPECT_EQ(judged(actual).record.state, State::Failed);
}

TEST_F(JudgeCase, RuleNoneIsTheTolerance) {
    plan(R"({"size": "16x16", "golden": "reference", "rule": "none", "tolerance": 255})");
    EXPECT_EQ(judged(plain(16, 16, red)).record.state, State::Passed);
    plan(R"({"size": "16x16", "golden": "reference", "rule": "none", "tolerance": 254})");
    EXPECT_EQ(judged(plain(16, 16, {255, 0, 255, 0})).record.metric, "absolute");
}

TEST_F(JudgeCase, WhatTheComparisonSkipsIsSkippedWithItsReason) {
    plan(R"({"size": "8x8", "golden": "reference", "set": "textures[0].compression=driver"})");
    const JudgedCase judged = this->judged(plain(8, 8, red));
    EXPECT_EQ(judged.record.state, State::Skipped);
    EXPECT_THAT(judged.record.sentence, HasSubstr("drivers may compress an image in any way"));
}

TEST_F(JudgeCase, MaskedPixelsDontCountForARuleEither) {
    plan(R"({"size": "8x8", "golden": "reference", "rule": "exact", "mask": "mask.png"})");
    Image actual = drawnByReference();
    setPixel(actual, 3, 3, {255, 0, 255, 255});
    Image mask = plain(8, 8, {255, 255, 255, 255});
    writePng(folder_ / "mask.png", mask);
    EXPECT_EQ(judged(actual).record.state, State::Failed);
    setPixel(mask, 3, 3, {0, 0, 0, 255});
    writePng(folder_ / "mask.png", mask);
    EXPECT_EQ(judged(actual).record.state, State::Passed);
    writePng(folder_ / "mask.png", plain(4, 4, {255, 255, 255, 255}));
    EXPECT_EQ(judged(actual).record.state, State::Error);
}

TEST_F(JudgeCase, TwoPicturesOfAnyProgram) {
    const JudgedCase same = judgePictures({}, "a.png", plain(2, 2, red), plain(2, 2, red));
    EXPECT_EQ(same.record.state, State::Passed);
    const JudgedCase other = judgePictures({}, "sub/a.png", plain(2, 2, red), plain(2, 2, darkRed));
    EXPECT_EQ(other.record.state, State::Failed);
    EXPECT_EQ(other.record.name, "sub/a.png");
    EXPECT_EQ(judgePictures({}, "a", plain(2, 2, red), plain(2, 1, red)).record.state, State::Resized);
}

TEST_F(JudgeCase, WithoutASceneThereIsARecordAtOnce) {
    Suite suite{.name = "s", .about = {}, .folder = folder_.path(), .entries = {Entry{}}};
    suite.entries[0].scenes = {SceneFile{"absent.json"}};
    const Result<Plan> plan = planOf({suite});
    ASSERT_TRUE(plan) << describe(plan.error());
    const std::optional<CaseRecord> record = recordWithoutDrawing(*plan, plan->cases[0]);
    ASSERT_TRUE(record);
    EXPECT_EQ(record->state, State::MissingScene);
    EXPECT_THAT(record->sentence, HasSubstr("absent.json"));
}

TEST_F(JudgeCase, AMaskThatHidesEverythingIsAnErrorWhateverTheGolden) {
    writePng(folder_ / "mask.png", plain(4, 4, {0, 0, 0, 255}));
    for (const char* golden : {R"("reference")", R"("a.png")", R"("reference", "rule": "none")"}) {
        plan(fmt::format(R"({{"size": "4x4", "mask": "mask.png", "golden": {}}})", golden));
        const JudgedCase judged = this->judged(plain(4, 4, red));
        EXPECT_EQ(judged.record.state, State::Error) << golden; // of a.png, which isn't there: nothing is new
        EXPECT_THAT(judged.record.sentence, HasSubstr("the mask leaves no pixel to compare")) << golden;
        EXPECT_FALSE(judged.goldenIsBroken);
    }
}

TEST_F(JudgeCase, AGoldenThatHoldsNoPictureIsBroken) {
    plan(R"({"size": "2x2", "golden": "a.png"})");
    const std::filesystem::path golden = folder_ / "a.png";
    ASSERT_TRUE(
        writeFileAtomically(golden, viewBytes("version https://git-lfs.github.com/spec/v1\noid sha256:0\n")));
    JudgedCase judged = this->judged(plain(2, 2, red));
    EXPECT_EQ(judged.record.state, State::Error);
    EXPECT_THAT(judged.record.sentence, HasSubstr("found a Git LFS pointer"));
    EXPECT_TRUE(judged.goldenIsBroken);
    EXPECT_EQ(judged.record.golden, "a.png");
    ASSERT_TRUE(writeFileAtomically(golden, viewBytes("hello")));
    EXPECT_TRUE(this->judged(plain(2, 2, red)).goldenIsBroken);

    std::filesystem::remove(golden); // it can't be read: what it holds isn't known
    std::filesystem::create_directory(golden);
    judged = this->judged(plain(2, 2, red));
    EXPECT_EQ(judged.record.state, State::Error);
    EXPECT_FALSE(judged.goldenIsBroken);
}

} // namespace
} // namespace texplorer::suite::judge_case_test
