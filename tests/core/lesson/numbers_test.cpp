// Texts with numbers that were worked out by hand.

#include "tests/support/flat_scene.h"
#include "texplorer/lesson/match.h"
#include "texplorer/lesson/numbers.h"

#include <gmock/gmock.h>

namespace texplorer::lesson::numbers_test {
namespace {

using testing::HasSubstr;

/// A square that fills the picture's height, with a texture of 2 x 2 texels: 0, 0.2, 0.4 and 1 of grey, the
/// lowest row first. A pixel is 1/72 wide; the square lies 24 pixels from the left edge of the picture.
LessonScene flat() {
    LessonScene flat;
    flat.scene = texplorer::test::texturedScene();
    flat.images.put(
        "image",
        Image{
            PixelFormat::Luminance8, 2, 2, 1, {std::byte{0}, std::byte{51}, std::byte{102}, std::byte{255}}});
    return flat;
}

constexpr PictureSize small{smallWidth, smallHeight};

Look lookAt(int x, int y) {
    Look look;
    look.probeX = x;
    look.probeY = y;
    return look;
}

std::string textAt(std::string_view text, int x, int y, const LessonScene& scene = flat(),
                   PictureSize picture = small) {
    const Result<Numbers> numbers = numbersOf(scene, lookAt(x, y), picture);
    EXPECT_TRUE(numbers) << describe(numbers.error());
    return numbers ? numbers->in(text) : "";
}

TEST(Numbers, WithoutAWordStaysAsItIs) {
    EXPECT_EQ(textAt("Because.", -1, -1), "Because.");
    EXPECT_EQ(textAt("An open { stays.", 500, 500), "An open { stays.");
    EXPECT_EQ(textAt("", 500, 500), "");
}

/// 300 of 1000 is column 57, whose centre lies 57.5 - 24 = 33.5 pixels in the square: s = 33.5 / 144 = 0.233.
/// 800 is row 115 from the top, 28 from the bottom: t = 28.5 / 144 = 0.198. Both are below 1/2: texel (0, 0).
TEST(Numbers, HasTheNumbersOfItsPixel) {
    EXPECT_EQ(textAt("{s}, {t}: {color}.", 300, 800), "0.233, 0.198: (0, 0, 0).");
    EXPECT_EQ(textAt("{texel}", 300, 800), "(0, 0, 0, 1)");
}

/// 700 is column 134: s = (134.5 - 24) / 144 = 0.767, and 100 is row 14 from the top, 129 from the bottom:
/// t = 129.5 / 144 = 0.899, and the texel is (1, 1).
TEST(Numbers, CountsPixelsFromTheTopLeft) {
    EXPECT_EQ(textAt("{s} {t} {texel} {color}", 700, 100), "0.767 0.899 (1, 1, 1, 1) (255, 255, 255)");
    EXPECT_EQ(textAt("{texel}", 300, 100), "(0.4, 0.4, 0.4, 1)") << "the upper row is the image's second";
    EXPECT_EQ(textAt("{texel}", 700, 800), "(0.2, 0.2, 0.2, 1)");
}

/// Two texels on 144 pixels: a pixel is 1/72 of a texel, and log2(1/72) = -6.17.
TEST(Numbers, HasTheLevelOfDetail) {
    EXPECT_EQ(textAt("{side} {up} {rho} {lambda} {level} {texels} {probes}", 300, 800),
              "0.01 0.01 0.01 -6.17 0 1 1");
    LessonScene linear = flat();
    linear.scene.textures[0].magFilter = MagFilter::Linear;
    EXPECT_EQ(textAt("{texels}", 300, 800, linear), "4");
}

/// The fragment before texturing is glColor, which GL_REPLACE ignores.
TEST(Numbers, HasTheFragment) {
    LessonScene scene = flat();
    scene.scene.material.color = {1, 0.5F, 0.25F, 1};
    EXPECT_EQ(textAt("{fragment} {color}", 300, 800, scene), "(1, 0.5, 0.25, 1) (0, 0, 0)");
    scene.scene.passes[0].units[0].envMode = EnvMode::Modulate;
    EXPECT_EQ(textAt("{fragment} {color}", 700, 100, scene), "(1, 0.5, 0.25, 1) (255, 128, 64)");
}

TEST(Numbers, HasADashWhereThereIsNoPixel) {
    EXPECT_EQ(textAt("{color}, {s}", -1, -1), "–, –");
    EXPECT_EQ(textAt("{texel}!", 10, 10), "–!") << "outside the square";
    EXPECT_EQ(Numbers("…").in("{s} and {nothing}"), "… and …");
}

/// Without a unit the pixel has the colour of glColor.
TEST(Numbers, HasTheColourWithoutAUnit) {
    LessonScene scene = flat();
    scene.scene.material.color = {1, 0.6F, 0.2F, 1};
    scene.scene.passes[0].units[0].enabled = false;
    EXPECT_EQ(textAt("{color} {fragment} {texel}", 300, 800, scene), "(255, 153, 51) (1, 0.6, 0.2, 1) –");
}

/// The image repeats 72 times in each direction, so that its 144 texels cover 144, 72 or 288 pixels, or half
/// of that horizontally.
TEST(Numbers, AreThoseOfThePictureThatIsShown) {
    LessonScene scene = flat();
    scene.scene.textures[0].mipmaps = MipPolicy::Generated;
    ASSERT_TRUE(
        makeEdits(scene.scene, std::vector<Edit>{edit::Set{"models[0].texCoords0", "0,0;36,0;36,72;0,72"}}));
    EXPECT_EQ(textAt("{side} {up} {rho}", 300, 800, scene), "0.50 1.00 1.00");
    EXPECT_EQ(textAt("{side} {up} {rho} {lambda}", 300, 800, scene, {96, 72}), "1.00 2.00 2.00 1.00");
    EXPECT_EQ(textAt("{side} {up} {rho} {lambda}", 300, 800, scene, {500, 288}), "0.25 0.50 0.50 -1.00");
}

/// A picture of another shape has the same middle and height: 600 is 100 thousandths of 4/3 of the height to
/// the right of the middle.
TEST(Numbers, FindTheMarkInAPictureOfAnyShape) {
    EXPECT_EQ(pixelOf(500, 500, {320, 240}), (reference::PixelPlace{160, 119}));
    EXPECT_EQ(pixelOf(600, 250, {320, 240}), (reference::PixelPlace{192, 179}));
    EXPECT_EQ(pixelOf(600, 250, {1000, 240}), (reference::PixelPlace{532, 179}));
    EXPECT_EQ(pixelOf(600, 250, {100, 240}), (reference::PixelPlace{82, 179}));
    EXPECT_EQ(pixelOf(900, 999, {100, 240}), (reference::PixelPlace{99, 0})) << "at its edge";
}

TEST(Numbers, APixelShowsTheSameInPicturesOfOtherSizes) {
    const PictureSize size{320, 240};
    for (const int x : {0, 7, 160, 319})
        EXPECT_EQ(pixelOf({x, 5}, size, size), (reference::PixelPlace{x, 5}));
    EXPECT_EQ(pixelOf({200, 60}, size, {420, 240}), (reference::PixelPlace{250, 60}))
        << "50 more on each side";
    EXPECT_EQ(pixelOf({200, 60}, size, {640, 480}), (reference::PixelPlace{401, 121}));
    EXPECT_EQ(pixelOf({401, 121}, {640, 480}, size), (reference::PixelPlace{200, 60}));
    EXPECT_EQ(pixelOf({319, 60}, size, {100, 240}), (reference::PixelPlace{99, 60})) << "at its edge";
}

TEST(Numbers, OfAStepAreThoseOfItsStartAndOfTheRightAnswer) {
    Step step{"S", "{color}", "", {}, lookAt(700, 100), {}};
    step.task = Predict{"Q",
                        {{"a", {edit::Set{"passes[0].units[0].enabled", "false"}}},
                         {"b", {edit::Set{"textures[0].baseLevel", "0"}}}},
                        0,
                        "{color}"};
    LessonScene scene = flat();
    scene.scene.material.color = {0, 0.2F, 0, 1};
    const Result<StepNumbers> numbers = numbersOf(scene, step, small);
    ASSERT_TRUE(numbers) << describe(numbers.error());
    EXPECT_EQ(numbers->start.in(step.text), "(255, 255, 255)");
    EXPECT_EQ(numbers->answered.in("{color}"), "(0, 51, 0)");
}

TEST(Numbers, IsCheckedForWordsThatThereAreNot) {
    EXPECT_TRUE(checkWords("{color} {s} {t} {side} {up} {level} {lambda} {rho} {probes} {texel} {texels} "
                           "{fragment} {"));
    for (const char* text : {"{colour}", "{s} and {}", "{ s}"}) {
        const Result<void> checked = checkWords(text);
        ASSERT_FALSE(checked) << text;
        EXPECT_THAT(checked.error().message, HasSubstr("expected one of {color}, {fragment}, "));
    }
}

} // namespace
} // namespace texplorer::lesson::numbers_test
