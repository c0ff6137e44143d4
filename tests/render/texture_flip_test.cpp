// One DDS texture, whose first row is the top one, drawn with every way to get it upright, and with none.

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"
#include "texplorer/s3tc/decode.h"

#include <gmock/gmock.h>

namespace texplorer::texture_flip_test {
namespace {

using namespace test;

/// Flat colours, a block each, so that every decoder and driver agrees on them: row 0 of blocks is the top.
BlockImage flatBlocks(int width, int height, std::initializer_list<std::uint16_t> colors) {
    BlockImage image = BlockImage::uninitialised(BlockFormat::Dxt1, width, height);
    EXPECT_EQ(image.blocks.size(), 8 * colors.size());
    auto out = image.blocks.begin();
    for (const std::uint16_t color : colors) {
        *out++ = static_cast<std::byte>(color & 0xFFU);
        *out++ = static_cast<std::byte>(color >> 8);
        out = std::fill_n(out, 6, std::byte{0}); // every texel takes the first colour, which is the larger
    }
    return image;
}

constexpr std::uint16_t red = 0xF800;
constexpr std::uint16_t green = 0x07E0;
constexpr std::uint16_t blue = 0x001F;
constexpr std::uint16_t white = 0xFFFF;

TextureImage ddsFile(int height = 8) {
    TextureImage file;
    file.format = "DDS";
    file.topFirst = true;
    file.surfaces.emplace_back(flatBlocks(8, height, {red, green, blue, white}));
    return file;
}

class Flip : public RenderTest {
protected:
    Image drawn(FlipMode flip, const Scene& from) {
        Scene scene = from;
        scene.textures[0].flip = flip;
        Image image = picture(scene, 16);
        EXPECT_THAT(problems, testing::IsEmpty()) << rowOf(flip).name;
        return image;
    }
    static void expectUpright(const Image& image, const char* name) {
        EXPECT_TRUE(isColor(colorAt(image, 4, 12), {1, 0, 0, 1})) << name << ": red is at the top left";
        EXPECT_TRUE(isColor(colorAt(image, 12, 12), {0, 1, 0, 1})) << name;
        EXPECT_TRUE(isColor(colorAt(image, 4, 4), {0, 0, 1, 1})) << name;
        EXPECT_TRUE(isColor(colorAt(image, 12, 4), {1, 1, 1, 1})) << name;
    }
    static constexpr std::array uprightModes{FlipMode::Blocks, FlipMode::Pixels, FlipMode::Coordinates,
                                             FlipMode::Matrix};
};

TEST_F(Flip, EveryModeDrawsTheSameUprightPicture) {
    images.put("image", ddsFile());
    for (const FlipMode flip : uprightModes)
        expectUpright(drawn(flip, texturedScene()), rowOf(flip).name.data());
}

TEST_F(Flip, NoneDrawsItUpsideDown) {
    images.put("image", ddsFile());
    const Image image = drawn(FlipMode::None, texturedScene());
    EXPECT_TRUE(isColor(colorAt(image, 4, 4), {1, 0, 0, 1})) << "red is at the bottom left";
    EXPECT_TRUE(isColor(colorAt(image, 12, 4), {0, 1, 0, 1}));
    EXPECT_TRUE(isColor(colorAt(image, 4, 12), {0, 0, 1, 1}));
    EXPECT_TRUE(isColor(colorAt(image, 12, 12), {1, 1, 1, 1}));
}

TEST_F(Flip, WorksOnEditedCoordinatesAndOnProjectiveOnes) {
    images.put("image", ddsFile());
    Scene scene = texturedScene();
    scene.models[0].texCoords[0] = quadCoords({0, 0, 0, 2}, {2, 2, 0, 2}); // divided by q = 2: 0 to 1
    for (const FlipMode flip : uprightModes)
        expectUpright(drawn(flip, scene), rowOf(flip).name.data());
}

// s by half a texture, t by a quarter: what a matrix does to an upright picture, the flip comes after it.
TEST_F(Flip, InTheMatrixLeavesTheOtherStepsWhatTheyAre) {
    images.put("image", ddsFile());
    Scene scene = texturedScene();
    scene.passes[0].units[0].matrix = {{.op = MatrixOp::Translate, .amount = {0.5F, 0.25F, 0}}};
    const Image expected = drawn(FlipMode::Blocks, scene);
    EXPECT_TRUE(isColor(colorAt(expected, 4, 0), {1, 1, 1, 1}));
    EXPECT_TRUE(isColor(colorAt(expected, 4, 6), {0, 1, 0, 1})) << "a quarter further down";
    EXPECT_EQ(drawn(FlipMode::Pixels, scene), expected);
    EXPECT_EQ(drawn(FlipMode::Matrix, scene), expected);
    EXPECT_NE(drawn(FlipMode::Coordinates, scene), expected)
        << "there the matrix works on flipped coordinates";
}

TEST_F(Flip, OfPatternsChangesNothing) {
    Scene scene = texturedScene();
    scene.textures[0].source = SourceKind::Pattern;
    scene.textures[0].pattern = Pattern::UvTemplate;
    const Image expected = drawn(FlipMode::Blocks, scene);
    for (const EnumRow& row : flipModeRows)
        EXPECT_EQ(drawn(static_cast<FlipMode>(row.value), scene), expected) << row.name;
}

TEST_F(Flip, ThatIsImpossibleWithoutLossIsSaidAndStillUpright) {
    TextureImage file;
    file.topFirst = true;
    file.surfaces.emplace_back(flatBlocks(8, 6, {red, green, blue, white})); // rows of 4 and 2 texels
    images.put("image", std::move(file));
    Scene scene = texturedScene();
    const Image image = picture(scene, 24);
    EXPECT_THAT(problems, testing::ElementsAre(testing::HasSubstr("8 × 6 texels")));
    EXPECT_TRUE(isColor(colorAt(image, 4, 20), {1, 0, 0, 1}));
    EXPECT_TRUE(isColor(colorAt(image, 4, 9), {1, 0, 0, 1})) << "two thirds are red";
    EXPECT_TRUE(isColor(colorAt(image, 4, 6), {0, 0, 1, 1}));
}

} // namespace
} // namespace texplorer::texture_flip_test
