// Blocks worked out by hand from EXT_texture_compression_s3tc and ARB_texture_compression_rgtc.

#include "tests/core/s3tc/squish_oracle.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/decode_rows.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace texplorer::decode_test {
namespace {

struct Case {
    const char* name;
    BlockFormat format;
    std::vector<int> block;
    int texel; ///< 0 to 15, row by row
    std::array<int, 4> rgba;
};

class DecodeBlock : public testing::TestWithParam<Case> {};

TEST_P(DecodeBlock, GivesTheTexelThatTheSpecificationSays) {
    const Case& row = GetParam();
    Bytes block;
    for (const int value : row.block)
        block.push_back(static_cast<std::byte>(value));
    ASSERT_EQ(block.size(), bytesPerBlock(row.format));
    std::array<std::byte, 64> texels{};
    decodeBlock(row.format, block.data(), texels.data());
    for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(std::to_integer<int>(texels[4 * static_cast<std::size_t>(row.texel) + c]), row.rgba[c])
            << c;
}

// Red is 0xF800, blue 0x001F; the codes 0xE4 are 0, 1, 2, 3 from left to right.
INSTANTIATE_TEST_SUITE_P(
    Rows, DecodeBlock,
    testing::Values(
        Case{"Dxt1First", BlockFormat::Dxt1, {0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0}, 0, {255, 0, 0, 255}},
        Case{"Dxt1Second", BlockFormat::Dxt1, {0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0}, 1, {0, 0, 255, 255}},
        Case{"Dxt1TwoThirds",
             BlockFormat::Dxt1,
             {0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0},
             2,
             {170, 0, 85, 255}},
        Case{
            "Dxt1OneThird", BlockFormat::Dxt1, {0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0}, 3, {85, 0, 170, 255}},
        Case{"Dxt1Half", BlockFormat::Dxt1, {0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0}, 2, {127, 0, 127, 255}},
        Case{"Dxt1Black", BlockFormat::Dxt1, {0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0}, 3, {0, 0, 0, 255}},
        Case{"Dxt1Hole", BlockFormat::Dxt1Alpha, {0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0}, 3, {0, 0, 0, 0}},
        Case{"Dxt1LastRow", BlockFormat::Dxt1, {0x00, 0xF8, 0x1F, 0x00, 0, 0, 0, 0x40}, 15, {0, 0, 255, 255}},
        Case{"Dxt3Alpha",
             BlockFormat::Dxt3,
             {0xA5, 0, 0, 0, 0, 0, 0, 0, 0x00, 0xF8, 0x1F, 0x00, 0xE4, 0, 0, 0},
             1,
             {0, 0, 255, 170}},
        Case{"Dxt3AlwaysFourColors",
             BlockFormat::Dxt3,
             {0xFF, 0xFF, 0, 0, 0, 0, 0, 0, 0x1F, 0x00, 0x00, 0xF8, 0xE4, 0, 0, 0},
             3,
             {170, 0, 85, 255}},
        // Alphas 240 and 16, code 2: (6 * 240 + 16) / 7 = 208.
        Case{"Dxt5Eight",
             BlockFormat::Dxt5,
             {240, 16, 2, 0, 0, 0, 0, 0, 0x00, 0xF8, 0x1F, 0x00, 0, 0, 0, 0},
             0,
             {255, 0, 0, 208}},
        // Alphas 16 and 240, code 5: (16 + 4 * 240) / 5 = 195.
        Case{"Dxt5Six",
             BlockFormat::Dxt5,
             {16, 240, 5, 0, 0, 0, 0, 0, 0x00, 0xF8, 0x1F, 0x00, 0, 0, 0, 0},
             0,
             {255, 0, 0, 195}},
        Case{"Dxt5Ends",
             BlockFormat::Dxt5,
             {16, 240, 7, 0, 0, 0, 0, 0, 0x00, 0xF8, 0x1F, 0x00, 0, 0, 0, 0},
             0,
             {255, 0, 0, 255}},
        Case{"Bc4", BlockFormat::Bc4, {240, 16, 2, 0, 0, 0, 0, 0}, 0, {208, 208, 208, 255}},
        Case{"Bc4SignedLow", BlockFormat::Bc4Signed, {0x81, 0x7F, 0, 0, 0, 0, 0, 0}, 0, {0, 0, 0, 255}},
        Case{
            "Bc4SignedHigh", BlockFormat::Bc4Signed, {0x81, 0x7F, 1, 0, 0, 0, 0, 0}, 0, {255, 255, 255, 255}},
        // -127 and -128 are both -1, but as numbers the first is larger: code 7 lies between them.
        Case{"Bc4SignedMinusOneTwice",
             BlockFormat::Bc4Signed,
             {0x81, 0x80, 7, 0, 0, 0, 0, 0},
             0,
             {0, 0, 0, 255}},
        Case{"Bc5",
             BlockFormat::Bc5,
             {240, 16, 2, 0, 0, 0, 0, 0, 16, 240, 5, 0, 0, 0, 0, 0},
             0,
             {208, 195, 0, 255}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(DecodeBlocks, CutsTheBlocksThatReachOverTheEdge) {
    BlockImage image = BlockImage::uninitialised(BlockFormat::Dxt1, 5, 6);
    ASSERT_EQ(image.blocks.size(), 4U * 8U);
    for (std::size_t block = 0; block < 4; ++block) {
        const std::array<int, 8> red{0x00, static_cast<int>(8 * (block + 1)), 0, 0, 0, 0, 0, 0};
        for (std::size_t i = 0; i < 8; ++i)
            image.blocks[8 * block + i] = static_cast<std::byte>(red[i]);
    }
    const Image pixels = decodeBlocks(image);
    ASSERT_EQ(pixels.pixels.size(), 5U * 6U * 4U);
    const auto redAt = [&](int x, int y) { return std::to_integer<int>(pixels.at(x, y)[0]); };
    // Red 1 to 4 of 31, widened: 8, 16, 24, 33.
    EXPECT_EQ(redAt(3, 3), 8);
    EXPECT_EQ(redAt(4, 0), 16);
    EXPECT_EQ(redAt(0, 4), 24);
    EXPECT_EQ(redAt(4, 5), 33);
}

BlockImage randomBlocks(BlockFormat format, int width, int height, int depth = 1) {
    BlockImage image = BlockImage::uninitialised(format, width, height, depth);
    std::mt19937 random(static_cast<unsigned>(width * 1000 + height * 10 + depth));
    for (std::byte& each : image.blocks)
        each = static_cast<std::byte>(random());
    // Equal colours and values, which chance hardly ever gives, take a branch of their own.
    for (std::size_t at = 0; at + 16 <= image.blocks.size(); at += 80) {
        image.blocks[at + 1] = image.blocks[at];
        std::memcpy(&image.blocks[at + 10], &image.blocks[at + 8], 2);
    }
    return image;
}

class EveryFormat : public testing::TestWithParam<EnumRow> {
protected:
    [[nodiscard]] static BlockFormat format() { return static_cast<BlockFormat>(GetParam().value); }
};

/// Texel by texel from decodeBlock.
Image decodeLiterally(const BlockImage& image) {
    Image pixels = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height, image.depth);
    const int columns = (image.width + 3) / 4;
    const int rows = (image.height + 3) / 4;
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto block = static_cast<std::size_t>((z * rows + y / 4) * columns + x / 4);
                std::array<std::byte, 64> texels{};
                decodeBlock(image.format, image.blocks.data() + block * bytesPerBlock(image.format),
                            texels.data());
                std::memcpy(pixels.at(x, y, z).data(),
                            texels.data() + static_cast<std::size_t>(16 * (y % 4) + 4 * (x % 4)), 4);
            }
    return pixels;
}

TEST_P(EveryFormat, DecodesLikeTheLiteralDecoderAtEverySize) {
    for (const int height : {1, 2, 3, 4, 5, 8, 13})
        for (int width = 1; width <= 17; ++width)
            for (const int depth : {1, 3}) {
                const BlockImage image = randomBlocks(format(), width, height, depth);
                ASSERT_EQ(decodeBlocks(image), decodeLiterally(image))
                    << width << " x " << height << " x " << depth;
            }
}

TEST_P(EveryFormat, DecodesLikeThePlainTwin) {
    const BlockImage image = randomBlocks(format(), 4 * 5000, 4);
    Image plain = Image::uninitialised(PixelFormat::Rgba8, image.width, 4);
    plainRowDecoder(format())(image.blocks.data(), 5000, plain.pixels.data(), plain.rowBytes());
    EXPECT_EQ(decodeBlocks(image), plain);
}

TEST_P(EveryFormat, DecodesEveryPairOfValuesLikeThePlainTwin) {
    BlockImage image = BlockImage::uninitialised(format(), 4 * 256, 4 * 256);
    const std::size_t size = bytesPerBlock(format());
    for (std::size_t at = 0; at < image.blocks.size(); ++at) {
        const std::size_t block = at / size;
        const std::array<std::size_t, 8> bytes{block & 255, block >> 8, 0x88, 0xC6, 0xFA, 0x88, 0xC6, 0xFA};
        image.blocks[at] = static_cast<std::byte>(bytes[at % 8]);
    }
    Image plain = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    for (std::size_t row = 0; row < 256; ++row)
        plainRowDecoder(format())(image.blocks.data() + row * image.blockRowBytes(), 256,
                                  plain.pixels.data() + 4 * row * plain.rowBytes(), plain.rowBytes());
    EXPECT_EQ(decodeBlocks(image), plain);
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryFormat, testing::ValuesIn(blockFormatRows),
                         [](const auto& test) { return std::string(test.param.name); });

class AgainstSquish : public testing::TestWithParam<EnumRow> {};

/// 0 to 3 of every pixel.
std::vector<int> channel(const Image& image, std::size_t index) {
    std::vector<int> values;
    for (std::size_t i = index; i < image.pixels.size(); i += 4)
        values.push_back(std::to_integer<int>(image.pixels[i]));
    return values;
}

constexpr std::array<std::pair<int, int>, 5> sizes{{{256, 256}, {64, 4}, {7, 5}, {2, 2}, {1, 1}}};

TEST_P(AgainstSquish, DecodesToTheSameBytes) {
    const auto format = static_cast<BlockFormat>(GetParam().value);
    for (const auto& [width, height] : sizes) {
        const BlockImage image = randomBlocks(format, width, height);
        const Image expected = decodeWithSquish(image);
        const Image found = decodeBlocks(image);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(channel(found, c), channel(expected, c))
                << width << " x " << height << ", channel " << c;
        // libsquish knows DXT1 with holes only.
        if (format == BlockFormat::Dxt1)
            EXPECT_EQ(channel(found, 3), std::vector<int>(static_cast<std::size_t>(width * height), 255));
        else
            EXPECT_EQ(channel(found, 3), channel(expected, 3)) << width << " x " << height;
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, AgainstSquish,
                         testing::Values(rowOf(BlockFormat::Dxt1), rowOf(BlockFormat::Dxt1Alpha),
                                         rowOf(BlockFormat::Dxt3), rowOf(BlockFormat::Dxt5)),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(RgtcAgainstSquish, DecodesToTheSameBytes) {
    for (const auto& [width, height] : sizes) {
        const BlockImage pairs = randomBlocks(BlockFormat::Bc5, width, height);
        const Image redAndGreen = decodeBlocks(pairs);
        for (std::size_t half = 0; half < 2; ++half) {
            BlockImage alone = BlockImage::uninitialised(BlockFormat::Bc4, width, height);
            for (std::size_t block = 0; block < alone.blocks.size() / 8; ++block)
                std::memcpy(&alone.blocks[8 * block], &pairs.blocks[16 * block + 8 * half], 8);
            const std::vector<int> expected = channel(decodeWithSquish(asDxt5Alpha(pairs, half)), 3);
            EXPECT_EQ(channel(redAndGreen, half), expected) << width << " x " << height;
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(channel(decodeBlocks(alone), c), expected) << width << " x " << height;
        }
    }
}

} // namespace
} // namespace texplorer::decode_test
