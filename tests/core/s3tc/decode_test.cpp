// Blocks worked out by hand from EXT_texture_compression_s3tc and ARB_texture_compression_rgtc.

#include "core/s3tc/decode.h"

#include <gtest/gtest.h>

namespace texplorer {
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

} // namespace
} // namespace texplorer
