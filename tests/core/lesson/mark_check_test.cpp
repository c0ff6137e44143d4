// Marks and numbers that are wrong, each as an author may write it.

#include "tests/support/flat_scene.h"
#include "texplorer/lesson/mark_check.h"

#include <gmock/gmock.h>

namespace texplorer::lesson::mark_check_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Eq;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

/// A square that fills the picture's height, with a texture of 2 x 2 texels, 72 times in each direction: in a
/// picture of 144 rows a texel is a pixel.
LessonScene tiled() {
    LessonScene tiled;
    Scene& scene = tiled.scene;
    scene = texplorer::test::texturedScene();
    scene.textures[0].magFilter = MagFilter::Linear;
    scene.textures[0].minFilter = MinFilter::Linear;
    tiled.images.put(
        "image",
        Image{
            PixelFormat::Luminance8, 2, 2, 1, {std::byte{0}, std::byte{51}, std::byte{102}, std::byte{255}}});
    EXPECT_TRUE(
        makeEdits(scene, std::vector<Edit>{edit::Set{"models[0].texCoords0", "0,0;72,0;72,72;0,72"}}));
    return tiled;
}

Step markedAt(int x, int y, std::string text = "T") {
    Step step{"S", std::move(text), "", {}, {}, {}};
    step.look.probeX = x;
    step.look.probeY = y;
    return step;
}

std::vector<Error> problemsOf(const Step& step, const LessonScene& scene = tiled()) {
    std::vector<Error> problems;
    checkMark(scene, step, "/steps/0", problems);
    return problems;
}

auto problem(const char* where, const char* says) {
    return AllOf(Field(&Error::where, Eq(std::string_view(where))), Field(&Error::message, HasSubstr(says)));
}

TEST(Mark, MayBeAnywhereOnTheModel) {
    EXPECT_THAT(problemsOf(markedAt(506, 400, "{color} {s} {t} {lambda}")), IsEmpty());
}

TEST(Mark, IsNotBesideIt) {
    EXPECT_THAT(problemsOf(markedAt(10, 10)),
                ElementsAre(problem("/steps/0/look/probe", "nothing is drawn at the mark, in the step's")));
}

TEST(Mark, IsOnTheModelOfTheRightAnswerAsWell) {
    Step step = markedAt(506, 400);
    step.task = Predict{"Q", {{"a", {edit::Set{"models[0].visible", "false"}}}, {"b", {}}}, 0, "R"};
    EXPECT_THAT(problemsOf(step),
                ElementsAre(problem("/steps/0/look/probe", "in the right answer's picture")));
}

/// In the middle of a picture whose width is odd, 401, a pixel's centre has s = 36, which is 72 texels.
TEST(Mark, IsNotBetweenTwoTexelsOfWhichOneIsRead) {
    LessonScene scene = tiled();
    scene.scene.textures[0].magFilter = MagFilter::Nearest;
    scene.scene.textures[0].minFilter = MinFilter::Nearest;
    EXPECT_THAT(problemsOf(markedAt(500, 403), scene),
                ElementsAre(problem("/steps/0/look/probe", "texels is between two texels")));
    EXPECT_THAT(problemsOf(markedAt(500, 403)), IsEmpty()) << "GL_LINEAR mixes them";
}

/// s = 2 is clamped to 1, the end of the last texel, whose next one is itself.
TEST(Mark, MayBeWhereCoordinatesAreClamped) {
    LessonScene scene = tiled();
    scene.scene.textures[0].magFilter = MagFilter::Nearest;
    scene.scene.textures[0].minFilter = MinFilter::Nearest;
    scene.scene.textures[0].wrapS = Wrap::Clamp;
    scene.scene.textures[0].wrapT = Wrap::Clamp;
    ASSERT_TRUE(
        makeEdits(scene.scene, std::vector<Edit>{edit::Set{"models[0].texCoords0", "2,2;3,2;3,3;2,3"}}));
    EXPECT_THAT(problemsOf(markedAt(506, 400), scene), IsEmpty());
    scene.scene.textures[0].wrapT = Wrap::Repeat;
    ASSERT_TRUE(
        makeEdits(scene.scene, std::vector<Edit>{edit::Set{"models[0].texCoords0", "2,2;3,2;3,2;2,2"}}));
    EXPECT_THAT(problemsOf(markedAt(506, 400), scene), ElementsAre(problem("/steps/0/look/probe", "t = ")))
        << "t = 2 is between the last texel and the first";
}

TEST(Mark, IsNotBetweenTwoLevelsOfWhichOneIsRead) {
    LessonScene scene = tiled();
    Texture& texture = scene.scene.textures[0];
    texture.mipmaps = MipPolicy::Generated;
    texture.minFilter = MinFilter::LinearMipmapNearest;
    texture.minLod = 0.5F;
    texture.maxLod = 0.5F;
    EXPECT_THAT(problemsOf(markedAt(506, 400), scene),
                ElementsAre(problem("/steps/0/look/probe", "lambda = 0.500 is between two levels")));
    texture.minFilter = MinFilter::LinearMipmapLinear;
    EXPECT_THAT(problemsOf(markedAt(506, 400), scene), IsEmpty());
}

TEST(Words, NeedAMark) {
    EXPECT_THAT(
        problemsOf(markedAt(-1, -1, "It is {color}.")),
        ElementsAre(problem("/steps/0/text", "{color} is a number of the mark, but look has no probe")));
}

/// A reason that would end in a dash.
TEST(Words, NeedANumber) {
    Step step = markedAt(506, 400);
    step.task = Predict{"Q",
                        {{"a", {}}, {"b", {edit::Set{"passes[0].units[0].enabled", "false"}}}},
                        1,
                        "It keeps {fragment}: {color}."};
    EXPECT_THAT(problemsOf(step), IsEmpty());
    std::get<Predict>(step.task).reason = "The texel is {texel}.";
    EXPECT_THAT(problemsOf(step),
                ElementsAre(problem("/steps/0/predict/reason", "{texel} has no number at the mark")));
    std::get<Predict>(step.task) = Predict{"{what}?", {{"a {texel}", {}}, {"b", {}}}, 0, "R"};
    EXPECT_THAT(problemsOf(step),
                ElementsAre(problem("/steps/0/predict/question", "expected one of {color}")));
}

/// Rho is 576 texels over the rows of the picture: 4.00, 2.40, 1.43 and 1.91.
TEST(TypedNumbers, AreFoundWhereAnotherSizeHasOthers) {
    LessonScene scene = tiled();
    ASSERT_TRUE(makeEdits(scene.scene,
                          std::vector<Edit>{edit::Set{"models[0].texCoords0", "0,0;288,0;288,288;0,288"}}));
    for (const char* text : {"Rho is 2.40.", "Rho is 2.4, which is much.", "About 1.43"})
        EXPECT_THAT(problemsOf(markedAt(506, 400, text), scene),
                    ElementsAre(problem("/steps/0/text", "expected the word")))
            << text;
    for (const char* text : {"Rho is {rho}.", "12.40 or 2.401", "2.40.5", "4.0 or 0.5", "Nothing."})
        EXPECT_THAT(problemsOf(markedAt(506, 400, text), scene), IsEmpty()) << text;
}

TEST(TypedNumbers, MayBeThoseOfEverySize) {
    LessonScene scene = tiled();
    scene.scene.textures[0].minLod = 2;
    EXPECT_THAT(problemsOf(markedAt(506, 400, "The clamped lambda is 2.00, or 2.0."), scene), IsEmpty());
}

} // namespace
} // namespace texplorer::lesson::mark_check_test
