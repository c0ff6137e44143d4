#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/sampled_texture.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

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
    const auto texelOf = [](const Image& image) { return levelOf(image, InternalFormat::Rgba).texels[0]; };
    EXPECT_TRUE(isNear(texelOf(bytes(PixelFormat::Alpha8, 1, 1, {51})), {0, 0, 0, 0.2F}));
    EXPECT_TRUE(isNear(texelOf(bytes(PixelFormat::Luminance8, 1, 1, {51})), {0.2F, 0.2F, 0.2F, 1}));
    EXPECT_TRUE(
        isNear(texelOf(bytes(PixelFormat::LuminanceAlpha8, 1, 1, {51, 102})), {0.2F, 0.2F, 0.2F, 0.4F}));
    EXPECT_TRUE(isNear(texelOf(bytes(PixelFormat::Rgb8, 1, 1, {51, 102, 153})), {0.2F, 0.4F, 0.6F, 1}));
}

TEST(LevelOf, CountsTheBorderApart) {
    const Level level = levelOf(bytes(PixelFormat::Alpha8, 3, 3, {0, 1, 2, 3, 255, 5, 6, 7, 8}),
                                InternalFormat::Alpha, Target::Texture2D, 1);
    EXPECT_EQ(level.size(), glm::ivec3(1, 1, 1));
    EXPECT_EQ(level.texels.size(), 9U);
}

struct StoredCase {
    InternalFormat format;
    glm::vec4 expected; ///< of (100, 150, 200, 60)
};
class StoredTexel : public testing::TestWithParam<StoredCase> {};

// Section 2.14.9: n = round(c (2^b - 1) / 255), worth n / (2^b - 1). With 4 bits 100 is 5.88, so 6 of 15, 150
// is 9 (8.82), 200 is 12 (11.8), 60 is 4 (3.5 and more). EXT_texture_sRGB: ((c / 255 + 0.055) / 1.055)^2.4.
TEST_P(StoredTexel, IsWhatItsNumbersStandFor) {
    const Image image = bytes(PixelFormat::Rgba8, 1, 1, {100, 150, 200, 60});
    EXPECT_TRUE(isNear(levelOf(image, GetParam().format).texels[0], GetParam().expected));
}

constexpr float light100 = 0.127438F;
constexpr float light150 = 0.304987F;
constexpr float light200 = 0.577580F;
constexpr float alpha60 = 60 / 255.0F;
using I = InternalFormat;
INSTANTIATE_TEST_SUITE_P(
    All, StoredTexel,
    testing::Values(StoredCase{I::Rgba4, glm::vec4(6, 9, 12, 4) / 15.0F},
                    StoredCase{I::Rgb4, {6 / 15.0F, 9 / 15.0F, 12 / 15.0F, 1}},
                    StoredCase{I::Rgb5, {12 / 31.0F, 18 / 31.0F, 24 / 31.0F, 1}},
                    StoredCase{I::Rgb5A1, {12 / 31.0F, 18 / 31.0F, 24 / 31.0F, 0}},
                    StoredCase{I::Rgba2, {1 / 3.0F, 2 / 3.0F, 2 / 3.0F, 1 / 3.0F}},
                    StoredCase{I::R3G3B2, {3 / 7.0F, 4 / 7.0F, 2 / 3.0F, 1}},
                    StoredCase{I::Luminance4, {6 / 15.0F, 6 / 15.0F, 6 / 15.0F, 1}},
                    StoredCase{I::Luminance4Alpha4, {6 / 15.0F, 6 / 15.0F, 6 / 15.0F, 4 / 15.0F}},
                    StoredCase{I::Intensity4, glm::vec4(6 / 15.0F)},
                    StoredCase{I::Alpha4, {0, 0, 0, 4 / 15.0F}},
                    StoredCase{I::Srgb8Alpha8, {light100, light150, light200, alpha60}},
                    StoredCase{I::Srgb8, {light100, light150, light200, 1}},
                    StoredCase{I::Sluminance8Alpha8, {light100, light100, light100, alpha60}},
                    StoredCase{I::Sluminance8, {light100, light100, light100, 1}}),
    [](const auto& test) { return std::string(rowOf(test.param.format).name); });

// The line near 0: 10 / 255 is below 0.04045, so a 12.92th.
TEST(StoredTexel, OfADarkSrgbColorLiesOnTheLine) {
    const Level level = levelOf(bytes(PixelFormat::Luminance8, 2, 1, {10, 11}), InternalFormat::Sluminance8);
    EXPECT_FLOAT_EQ(level.texels[0].r, 10 / 255.0F / 12.92F);
    EXPECT_NEAR(level.texels[1].r, 0.0033465, 1e-7); // (0.043137 + 0.055) / 1.055 to the power of 2.4
}

TEST(BytesOf, AreThoseOfTexelsThatAre255ths) {
    const std::array texels{glm::vec4(0, 1, 128, 255) / 255.0F, glm::vec4(6, 9, 0, 15) / 15.0F};
    const std::vector<std::int32_t> found = bytesOf(texels);
    std::array<int, 8> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = std::to_integer<int>(std::as_bytes(std::span(found))[i]);
    EXPECT_THAT(numbers, testing::ElementsAre(0, 1, 128, 255, 102, 153, 0, 255));
    for (const float odd : {12 / 31.0F, 0.5F, -1 / 255.0F, 256 / 255.0F, std::nanf("")})
        EXPECT_THAT(bytesOf(std::array{texels[0], glm::vec4(0, 0, odd, 1)}), testing::IsEmpty()) << odd;
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
    levels.internalFormat = texture.internalFormat;
    levels.levels = {{0, bytes(PixelFormat::Rgba8, 1, 2, {255, 0, 0, 0, 51, 0, 0, 0})}};
    levels.lastLevel = 0;
    std::vector<Sentence> notes;
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
    EXPECT_EQ(sampled.level(0)->bytes, bytesOf(sampled.level(0)->texels));
    EXPECT_EQ(sampled.level(0)->bytes.size(), 2U);
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
    levels.internalFormat = InternalFormat::Alpha; // says nothing about a compressed texture
    std::vector<Sentence> notes;
    const Texture texture;
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
