// Reasons with their numbers, which are worked out by hand.

#include "core/lesson/match.h"
#include "core/lesson/reason.h"

#include <gmock/gmock.h>

namespace texplorer::lesson::reason_test {
namespace {

using testing::HasSubstr;

/// A square that fills the picture's height, with a texture of 2 x 2 texels: 0, 0.2, 0.4 and 1 of grey, the
/// lowest row first. A pixel is 1/72 wide; the square lies 24 pixels from the left edge of the picture.
LessonScene flat() {
    LessonScene flat;
    Scene& scene = flat.scene;
    scene.view.projection = Projection::Orthographic;
    scene.view.fieldOfView = 90;
    scene.view.distance = 1;
    scene.models.resize(1);
    scene.models[0].shape = Shape::Quad;
    scene.textures.resize(1);
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "four";
    scene.textures[0].magFilter = MagFilter::Nearest;
    scene.textures[0].minFilter = MinFilter::Nearest;
    scene.passes[0].units[0].enabled = true;
    scene.passes[0].units[0].envMode = EnvMode::Replace;
    flat.images.put(
        "four",
        Image{
            PixelFormat::Luminance8, 2, 2, 1, {std::byte{0}, std::byte{51}, std::byte{102}, std::byte{255}}});
    return flat;
}

std::string reasonAt(std::string_view reason, int x, int y, const LessonScene& scene = flat()) {
    const Result<std::string> text = reasonOf(reason, scene, x, y);
    EXPECT_TRUE(text) << describe(text.error());
    return text.value_or("");
}

TEST(Reason, WithoutAWordStaysAsItIs) {
    EXPECT_EQ(reasonAt("Because.", -1, -1), "Because.");
    EXPECT_EQ(reasonAt("An open { stays.", 500, 500), "An open { stays.");
    EXPECT_EQ(reasonAt("", 500, 500), "");
}

/// 300 of 1000 is column 57, whose centre lies 57.5 - 24 = 33.5 pixels in the square: s = 33.5 / 144 = 0.233.
/// 800 is row 115 from the top, 28 from the bottom: t = 28.5 / 144 = 0.198. Both are below 1/2: texel (0, 0).
TEST(Reason, HasTheNumbersOfItsPixel) {
    EXPECT_EQ(reasonAt("{s}, {t}: {color}.", 300, 800), "0.233, 0.198: (0, 0, 0).");
    EXPECT_EQ(reasonAt("{texel}", 300, 800), "(0, 0, 0, 1)");
}

/// 700 is column 134: s = (134.5 - 24) / 144 = 0.767, and 100 is row 14 from the top, 129 from the bottom:
/// t = 129.5 / 144 = 0.899, and the texel is (1, 1).
TEST(Reason, CountsPixelsFromTheTopLeft) {
    EXPECT_EQ(reasonAt("{s} {t} {texel} {color}", 700, 100), "0.767 0.899 (1, 1, 1, 1) (255, 255, 255)");
    EXPECT_EQ(reasonAt("{texel}", 300, 100), "(0.4, 0.4, 0.4, 1)") << "the upper row is the image's second";
    EXPECT_EQ(reasonAt("{texel}", 700, 800), "(0.2, 0.2, 0.2, 1)");
}

/// Two texels on 144 pixels: a pixel is 1/72 of a texel, and log2(1/72) = -6.17.
TEST(Reason, HasTheLevelOfDetail) {
    EXPECT_EQ(reasonAt("{rho} {lambda} {level} {texels}", 300, 800), "0.01 -6.17 0 1");
    LessonScene linear = flat();
    linear.scene.textures[0].magFilter = MagFilter::Linear;
    EXPECT_EQ(reasonAt("{texels}", 300, 800, linear), "4");
}

/// What the fragment was before texturing: glColor, which replacing passes over.
TEST(Reason, HasTheFragment) {
    LessonScene scene = flat();
    scene.scene.material.color = {1, 0.5F, 0.25F, 1};
    EXPECT_EQ(reasonAt("{fragment} {color}", 300, 800, scene), "(1, 0.5, 0.25, 1) (0, 0, 0)");
    scene.scene.passes[0].units[0].envMode = EnvMode::Modulate;
    EXPECT_EQ(reasonAt("{fragment} {color}", 700, 100, scene), "(1, 0.5, 0.25, 1) (255, 128, 64)");
}

TEST(Reason, HasADashWhereThereIsNoPixel) {
    EXPECT_EQ(reasonAt("{color}, {s}", -1, -1), "–, –");
    EXPECT_EQ(reasonAt("{texel}!", 10, 10), "–!") << "beside the square";
}

TEST(Reason, IsCheckedForWordsThatThereAreNot) {
    EXPECT_TRUE(checkReason("{color} {s} {t} {level} {lambda} {rho} {texel} {texels} {fragment} {"));
    for (const char* reason : {"{colour}", "{s} and {}", "{ s}"}) {
        const Result<void> checked = checkReason(reason);
        ASSERT_FALSE(checked) << reason;
        EXPECT_THAT(checked.error().message, HasSubstr("expected one of {color}, {s}, "));
    }
}

} // namespace
} // namespace texplorer::lesson::reason_test
