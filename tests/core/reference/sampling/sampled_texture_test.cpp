#include "core/reference/sampling/sampled_texture.h"
#include "tests/core/reference/textures.h"

#include <gmock/gmock.h>

namespace texplorer::reference::sampled_texture_test {
namespace {

using namespace test;

struct Case {
    const char* name;
    BaseFormat format;
    glm::vec4 expected;
};
class SourceColor : public testing::TestWithParam<Case> {};

// Tables 3.15 and 3.20 for R = 0.1, G = 0.2, B = 0.3, A = 0.4.
TEST_P(SourceColor, IsThatOfTheTables) {
    EXPECT_EQ(sourceColor(GetParam().format, {0.1F, 0.2F, 0.3F, 0.4F}), GetParam().expected);
}

using F = BaseFormat;
INSTANTIATE_TEST_SUITE_P(All, SourceColor,
                         testing::Values(Case{"Alpha", F::Alpha, {0, 0, 0, 0.4F}},
                                         Case{"Luminance", F::Luminance, {0.1F, 0.1F, 0.1F, 1}},
                                         Case{"LuminanceAlpha", F::LuminanceAlpha, {0.1F, 0.1F, 0.1F, 0.4F}},
                                         Case{"Intensity", F::Intensity, {0.1F, 0.1F, 0.1F, 0.1F}},
                                         Case{"Rgb", F::Rgb, {0.1F, 0.2F, 0.3F, 1}},
                                         Case{"Rgba", F::Rgba, {0.1F, 0.2F, 0.3F, 0.4F}}),
                         [](const auto& test) { return std::string(test.param.name); });

Image bytes(PixelFormat format, int width, int height, std::initializer_list<int> values) {
    Image image{format, width, height, 1, {}};
    for (const int value : values)
        image.pixels.push_back(static_cast<std::byte>(value));
    return image;
}

TEST(LevelOf, WidensEveryPixelFormat) {
    EXPECT_TRUE(isNear(levelOf(bytes(PixelFormat::Alpha8, 1, 1, {51}), F::Rgba).texels[0], {0, 0, 0, 0.2F}));
    EXPECT_TRUE(isNear(levelOf(bytes(PixelFormat::Luminance8, 1, 1, {51}), F::Rgba).texels[0],
                       {0.2F, 0.2F, 0.2F, 1}));
    EXPECT_TRUE(isNear(levelOf(bytes(PixelFormat::LuminanceAlpha8, 1, 1, {51, 102}), F::Rgba).texels[0],
                       {0.2F, 0.2F, 0.2F, 0.4F}));
    EXPECT_TRUE(isNear(levelOf(bytes(PixelFormat::Rgb8, 1, 1, {51, 102, 153}), F::Rgba).texels[0],
                       {0.2F, 0.4F, 0.6F, 1}));
}

TEST(LevelOf, CountsTheBorderApart) {
    const Level level = levelOf(bytes(PixelFormat::Alpha8, 3, 3, {0, 1, 2, 3, 255, 5, 6, 7, 8}), F::Alpha,
                                Target::Texture2D, 1);
    EXPECT_EQ(level.size(), glm::ivec3(1, 1, 1));
    EXPECT_EQ(level.texels.size(), 9U);
}

TEST(SampledTexture, TakesTheParametersOfTheTextureAndTheLimitsOfTheFile) {
    Texture texture;
    texture.internalFormat = InternalFormat::Luminance;
    texture.borderColor = {2, 0.5F, -1, 0.25F};
    texture.wrapT = Wrap::Clamp;
    texture.minFilter = MinFilter::Linear;
    texture.lodBias = 0.5F;
    texture.maxAnisotropy = 3;
    TextureLevels levels;
    levels.levels = {{0, bytes(PixelFormat::Rgba8, 1, 2, {255, 0, 0, 0, 51, 0, 0, 0})}};
    levels.lastLevel = 0;
    std::vector<std::string> notes;
    const SampledTexture sampled = sampledTexture(texture, levels, Target::Texture2D, notes).value();
    EXPECT_EQ(sampled.format, F::Luminance);
    EXPECT_EQ(sampled.borderColor, glm::vec4(1, 1, 1, 1));
    EXPECT_EQ(sampled.wrap(1), Wrap::Clamp);
    EXPECT_EQ(sampled.maxLevel, 0);
    SamplerState expected = texture; // all but what is the format's and the file's
    expected.borderColor = sampled.borderColor;
    expected.maxLevel = sampled.maxLevel;
    EXPECT_EQ(static_cast<const SamplerState&>(sampled), expected);
    ASSERT_NE(sampled.level(0), nullptr);
    EXPECT_EQ(sampled.level(1), nullptr);
    EXPECT_TRUE(isNear(sampled.level(0)->texels[1], {0.2F, 0.2F, 0.2F, 1}));
    EXPECT_THAT(notes, testing::IsEmpty());
}

TEST(SampledTexture, DecompressesBlocksAndSaysWhatStandsInForTheDriver) {
    // One DXT1 block: both colours red, 5:6:5.
    BlockImage block = BlockImage::uninitialised(BlockFormat::Dxt1, 4, 4);
    const auto red = {0x00, 0xF8, 0x00, 0xF8, 0, 0, 0, 0};
    std::ranges::transform(red, block.blocks.begin(),
                           [](int value) { return static_cast<std::byte>(value); });
    TextureLevels levels;
    levels.levels = {{0, block}};
    std::vector<std::string> notes;
    Texture texture;
    texture.internalFormat = InternalFormat::Alpha; // says nothing about a compressed texture
    const SampledTexture sampled = sampledTexture(texture, levels, Target::Texture2D, notes).value();
    EXPECT_EQ(sampled.format, F::Rgb);
    EXPECT_TRUE(isNear(sampled.level(0)->texels[5], {1, 0, 0, 1}));
    EXPECT_THAT(notes, testing::IsEmpty());

    levels.levels = {{0, bytes(PixelFormat::Rgb8, 1, 1, {255, 0, 0})}};
    levels.driverFormat = BlockFormat::Dxt5;
    EXPECT_EQ(sampledTexture(texture, levels, Target::Texture2D, notes).value().format, F::Rgba);
    EXPECT_THAT(notes, testing::ElementsAre(testing::HasSubstr("GL_COMPRESSED_RGBA_S3TC_DXT5_EXT")));

    notes.clear();
    std::stop_source stopped;
    stopped.request_stop();
    const Result<SampledTexture> none =
        sampledTexture(texture, levels, Target::Texture2D, notes, stopped.get_token());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::Cancelled);
    EXPECT_THAT(notes, testing::IsEmpty()) << "nothing was compressed";
}

} // namespace
} // namespace texplorer::reference::sampled_texture_test
