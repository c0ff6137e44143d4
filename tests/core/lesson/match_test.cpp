#include "texplorer/lesson/match.h"

#include <gmock/gmock.h>

namespace texplorer::lesson::match_test {
namespace {

Scene edited(const Scene& scene, const std::vector<Edit>& edits) {
    Scene target = scene;
    const Result<void> made = makeEdits(target, edits);
    EXPECT_TRUE(made) << describe(made.error());
    return target;
}

Grade gradeOf(const Scene& scene, const Scene& target) {
    const Result<Grade> grade = gradeMatch(scene, target, ImageSource{});
    EXPECT_TRUE(grade) << describe(grade.error());
    return grade.value_or(Grade{});
}

SceneChange hintOf(const Scene& scene, const Scene& target) {
    const auto hint = hintFor(scene, target, ImageSource{});
    EXPECT_TRUE(hint && *hint);
    return hint && *hint ? **hint : SceneChange{};
}

TEST(Match, IsReachedByTheSamePicture) {
    const Scene scene = defaultScene();
    const Grade same = gradeOf(scene, scene);
    EXPECT_TRUE(same.passed);
    EXPECT_EQ(same.share, 0);
    EXPECT_FALSE(hintFor(scene, scene, ImageSource{}).value());
    EXPECT_TRUE(gradeOf(scene, edited(scene, {edit::Set{"textures[0].priority", "0.25"}})).passed)
        << "another scene with the same picture";
    EXPECT_TRUE(gradeOf(scene, edited(scene, {edit::Set{"view.background", "0.113,0.13,0.16,1"}})).passed)
        << "two 255ths are nothing";
}

TEST(Match, HintsAtTheOneEditThatIsMissing) {
    const Scene scene = defaultScene();
    const Scene target = edited(scene, {edit::Set{"view.background", "1,0,0.5,1"}});
    const Grade grade = gradeOf(scene, target);
    EXPECT_FALSE(grade.passed);
    EXPECT_GT(grade.share, 0.3) << "all of the background";
    EXPECT_LT(grade.share, 1);
    const SceneChange hint = hintOf(scene, target);
    EXPECT_EQ(hint.path, "view.background");
    EXPECT_EQ(hint.to, "1,0,0.5,1");
}

TEST(Match, HintsAtTheEditThatReducesTheDifferenceMost) {
    const Scene scene = defaultScene();
    const std::vector<Edit> edits{edit::Set{"textures[0].priority", "0.5"}, // changes nothing that is seen
                                  edit::Set{"view.background", "1,1,1,1"},  // most of the picture
                                  edit::Set{"passes[0].units[0].envMode", "GL_REPLACE"}};
    const Scene target = edited(scene, edits);
    const Grade first = gradeOf(scene, target);
    EXPECT_EQ(hintOf(scene, target).path, "view.background");
    const Grade second = gradeOf(edited(scene, {edits[1]}), target);
    EXPECT_EQ(hintOf(edited(scene, {edits[1]}), target).path, "passes[0].units[0].envMode");
    EXPECT_LT(second.share, first.share);
    EXPECT_TRUE(gradeOf(edited(scene, {edits[1], edits[2]}), target).passed);
}

TEST(Match, HintsAtWhatTheStudentChangedAmiss) {
    const Scene start = defaultScene();
    const Scene target = edited(start, {edit::Set{"passes[0].units[0].envMode", "GL_REPLACE"}});
    const Scene amiss = edited(target, {edit::Set{"models[0].visible", "false"}});
    const SceneChange hint = hintOf(amiss, target);
    EXPECT_EQ(hint.path, "models[0].visible");
    EXPECT_EQ(hint.to, "true");
}

/// Neither alone shows anything.
TEST(Match, HintsAtTheFirstOfTwoThatShowOnlyTogether) {
    const Scene start = edited(defaultScene(), {edit::Set{"passes[0].alphaTest", "false"}});
    const Scene target = edited(
        start, {edit::Set{"passes[0].alphaTest", "true"}, edit::Set{"passes[0].alphaFunc", "GL_NEVER"}});
    EXPECT_FALSE(gradeOf(start, target).passed);
    EXPECT_EQ(hintOf(start, target).path, "passes[0].alphaTest");
}

TEST(Match, ComparesColoursAndNotAlpha) {
    const Scene scene = defaultScene();
    EXPECT_TRUE(gradeOf(scene, edited(scene, {edit::Set{"view.background", "0.11,0.13,0.16,0"}})).passed);
}

TEST(Match, StopsWhenItIsTold) {
    std::stop_source stop;
    stop.request_stop();
    const Result<Grade> grade = gradeMatch(defaultScene(), defaultScene(), ImageSource{}, stop.get_token());
    ASSERT_FALSE(grade);
    EXPECT_EQ(grade.error().code, ErrorCode::Cancelled);
    EXPECT_FALSE(hintFor(defaultScene(), defaultScene(), ImageSource{}, stop.get_token()));
}

/// On a page a background with an alpha of 0 would be white paper, and answers that differ in alpha alike.
TEST(SmallPictures, AreOpaque) {
    Scene scene = defaultScene();
    scene.view.background = {0, 0, 0, 0};
    const Image picture = drawSmall({scene, ImageSource{}}).value();
    for (std::size_t alpha = 3; alpha < picture.pixels.size(); alpha += 4)
        ASSERT_EQ(picture.pixels[alpha], std::byte{255});
    EXPECT_EQ(picture.pixels[0], std::byte{0}) << "and as black as it was";
}

TEST(SmallPictures, AreAlikeUpToAPixelInAThousand) {
    const Image one = drawSmall({defaultScene(), ImageSource{}}).value();
    EXPECT_EQ(one.width, smallWidth);
    EXPECT_EQ(one.height, smallHeight);
    Image other = one;
    constexpr int allowed = smallWidth * smallHeight / 1000; // 27
    for (int i = 0; i < allowed; ++i)
        other.pixels[static_cast<std::size_t>(i) * 4] ^= std::byte{0x80};
    EXPECT_TRUE(areAlike(one, other));
    other.pixels[std::size_t{allowed} * 4] ^= std::byte{0x80};
    EXPECT_FALSE(areAlike(one, other));
    EXPECT_FALSE(areAlike(one, Image{}));
}

} // namespace
} // namespace texplorer::lesson::match_test
