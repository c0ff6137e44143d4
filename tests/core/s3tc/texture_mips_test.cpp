#include "texplorer/image/mipmaps.h"
#include "texplorer/s3tc/encode.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/s3tc/texture_mips.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace texplorer::texture_mips_test {
namespace {

/// One component a pixel, bottom row first.
Image grey(int width, int height, std::initializer_list<int> values) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height);
    std::ranges::transform(values, image.pixels.begin(),
                           [](int value) { return static_cast<std::byte>(value); });
    return image;
}

BlockImage plainBlocks(BlockFormat format, int width, int height, std::byte value) {
    Image image = Image::uninitialised(PixelFormat::Rgb8, width, height);
    std::ranges::fill(image.pixels, value);
    return encodeBlocks(image, format, EncodeQuality::Fast).value();
}

TEST(TextureMips, AveragesTheBaseOfEachFaceDownToOneTexel) {
    TextureImage texture;
    texture.faces = 2;
    texture.surfaces.emplace_back(grey(2, 2, {0, 20, 40, 100}));
    texture.surfaces.emplace_back(grey(2, 2, {255, 255, 255, 255}));
    ASSERT_TRUE(buildMips(texture));
    ASSERT_EQ(texture.levels, 2);
    ASSERT_EQ(texture.surfaces.size(), 4);
    EXPECT_EQ(std::get<Image>(texture.surface(0, 1)), grey(1, 1, {40})) << "(0 + 20 + 40 + 100) / 4";
    EXPECT_EQ(std::get<Image>(texture.surface(1, 0)), grey(2, 2, {255, 255, 255, 255}));
    EXPECT_EQ(std::get<Image>(texture.surface(1, 1)), grey(1, 1, {255}));
}

TEST(TextureMips, ReplacesTheLevelsThatThereAre) {
    TextureImage texture;
    texture.levels = 2;
    texture.surfaces = {grey(4, 1, {8, 8, 8, 8}), grey(2, 1, {1, 2})};
    ASSERT_TRUE(buildMips(texture));
    ASSERT_EQ(texture.levels, 3);
    EXPECT_EQ(std::get<Image>(texture.surface(0, 1)), grey(2, 1, {8, 8}));
}

TEST(TextureMips, KeepsTheBlocksOfACompressedBase) {
    TextureImage texture;
    texture.surfaces.emplace_back(plainBlocks(BlockFormat::Dxt1, 16, 8, std::byte{0xff}));
    const Surface base = texture.surfaces.front();
    ASSERT_TRUE(buildMips(texture));
    ASSERT_EQ(texture.levels, 5) << "16 × 8, 8 × 4, 4 × 2, 2 × 1, 1 × 1";
    EXPECT_EQ(texture.surfaces.front(), base);
    for (int level = 1; level < texture.levels; ++level) {
        const auto& blocks = std::get<BlockImage>(texture.surface(0, level));
        EXPECT_EQ(blocks.format, BlockFormat::Dxt1);
        EXPECT_EQ(blocks.width, 16 >> level);
        const Image pixels = toImage(blocks);
        for (const std::byte each : pixels.pixels)
            EXPECT_EQ(each, std::byte{0xff}) << "white stays white";
    }
}

TEST(TextureMips, ScalesTheBaseToPowersOfTwoWhereItIsTold) {
    for (const bool compressed : {false, true}) {
        TextureImage texture;
        if (compressed)
            texture.surfaces.emplace_back(plainBlocks(BlockFormat::Dxt5, 24, 20, std::byte{0}));
        else
            texture.surfaces.emplace_back(
                Image{PixelFormat::Luminance8, 24, 20, 1, Bytes(std::size_t{24} * 20)});
        ASSERT_TRUE(buildMips(texture, {.npot = NpotPolicy::PowerOfTwo}));
        EXPECT_EQ(widthOf(texture.surface(0, 0)), 32) << "as gluBuild2DMipmaps has it";
        EXPECT_EQ(heightOf(texture.surface(0, 0)), 16);
        EXPECT_EQ(texture.levels, 6);
        EXPECT_EQ(texture.surfaces.back().index(), compressed ? 1U : 0U);
    }
}

TEST(TextureMips, LeavesTheTextureAsItWasWhereItCant) {
    const auto expectRefused = [](TextureImage texture, ErrorCode code) {
        const TextureImage original = texture;
        const Result<void> built = buildMips(texture);
        ASSERT_FALSE(built);
        EXPECT_EQ(built.error().code, code) << built.error().message;
        EXPECT_EQ(texture.surfaces, original.surfaces);
        EXPECT_EQ(texture.levels, original.levels);
    };
    expectRefused(TextureImage{}, ErrorCode::Malformed);
    TextureImage outline;
    outline.surfaces.emplace_back(Image{PixelFormat::Rgb8, 4, 4, 1, {}});
    expectRefused(outline, ErrorCode::Malformed);
    TextureImage signedBlocks;
    signedBlocks.surfaces.emplace_back(BlockImage{BlockFormat::Bc4Signed, 8, 8, 1, Bytes(32)});
    expectRefused(signedBlocks, ErrorCode::Unsupported);
    TextureImage volume;
    volume.surfaces.emplace_back(BlockImage{BlockFormat::Dxt1, 8, 8, 2, Bytes(64)});
    expectRefused(volume, ErrorCode::Unsupported);
}

} // namespace
} // namespace texplorer::texture_mips_test
