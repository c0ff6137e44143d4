// Blocks read by hand from EXT_texture_compression_s3tc, and held against libsquish's decoder.

#include "tests/core/s3tc/squish_oracle.h"
#include "texplorer/s3tc/block_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace texplorer::block_parts_test {
namespace {

using Kind = BlockMark::Kind;
using testing::ElementsAre;

constexpr std::array formats{BlockFormat::Dxt1, BlockFormat::Dxt1Alpha, BlockFormat::Dxt3, BlockFormat::Dxt5};

BlockBytes bytes(std::initializer_list<int> values) {
    BlockBytes block{};
    std::size_t i = 0;
    for (const int value : values)
        block[i++] = static_cast<std::byte>(value);
    return block;
}

BlockBytes noise(BlockFormat format, std::mt19937& random) {
    BlockBytes block{};
    for (std::size_t i = 0; i < bytesPerBlock(format); ++i)
        block[i] = static_cast<std::byte>(random());
    return block;
}

// Red 0xF800 and blue 0x001F; the first row's indices are 0, 1, 2, 3 from left to right: 11 10 01 00.
const BlockBytes redToBlue = bytes({0x00, 0xF8, 0x1F, 0x00, 0xE4, 0x00, 0x00, 0x40});

TEST(BlockParts, EveryBitBelongsToOneField) {
    for (const BlockFormat format : formats) {
        int next = 0;
        for (const BlockField& field : blockFields(format)) {
            EXPECT_EQ(field.first, next);
            for (int bit = field.first; bit < field.first + field.bits; ++bit)
                EXPECT_EQ(blockFields(format)[fieldAtBit(format, bit)], field);
            next += field.bits;
        }
        EXPECT_EQ(next, 8 * static_cast<int>(bytesPerBlock(format)));
        int byte = 0;
        for (const BlockBytesGroup& group : blockGroups(format)) {
            EXPECT_EQ(group.first, byte);
            byte += group.count;
        }
        EXPECT_EQ(byte, static_cast<int>(bytesPerBlock(format)));
    }
}

TEST(BlockParts, FieldsOfDxt1) {
    const BlockFields fields = fieldsOf(BlockFormat::Dxt1, redToBlue);
    EXPECT_THAT(fields.colors, ElementsAre(0xF800, 0x001F));
    EXPECT_THAT(fields.indices, ElementsAre(0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1));
}

// Rows 0 and 1 lie in bytes 2 to 4: texels 0 to 7 have the alphas 0 to 7 in 0xFAC688, three bits each.
TEST(BlockParts, FieldsOfDxt5) {
    const BlockFields fields =
        fieldsOf(BlockFormat::Dxt5,
                 bytes({240, 16, 0x88, 0xC6, 0xFA, 0x01, 0x00, 0x80, 0x00, 0xF8, 0x1F, 0x00, 0, 0, 0, 0}));
    EXPECT_THAT(fields.alphaEnds, ElementsAre(240, 16));
    EXPECT_THAT(fields.alphas, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 1, 0, 0, 0, 0, 0, 0, 4));
    EXPECT_THAT(fields.colors, ElementsAre(0xF800, 0x001F));
}

TEST(BlockParts, FieldsOfDxt3) {
    const BlockFields fields = fieldsOf(
        BlockFormat::Dxt3, bytes({0xA5, 0x10, 0, 0, 0, 0, 0, 0xF0, 0x00, 0xF8, 0x1F, 0, 0, 0, 0, 0}));
    EXPECT_THAT(fields.alphas, ElementsAre(5, 10, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 15));
}

TEST(BlockParts, FieldsMakeTheBlockThatTheyCameFrom) {
    std::mt19937 random(7);
    for (const BlockFormat format : formats)
        for (int i = 0; i < 500; ++i) {
            const BlockBytes block = noise(format, random);
            ASSERT_EQ(blockOf(format, fieldsOf(format, block)), block);
            ASSERT_EQ(blockOfHex(format, hexOf(format, block)).value(), block);
        }
}

// What a texel's numbers mean is what libsquish decodes, whichever end is the larger.
TEST(BlockParts, PalettesAreThoseOfLibsquish) {
    std::mt19937 random(8);
    int threeColors = 0;
    int sixAlphas = 0;
    for (const BlockFormat format : {BlockFormat::Dxt1Alpha, BlockFormat::Dxt3, BlockFormat::Dxt5})
        for (int i = 0; i < 500; ++i) {
            const BlockBytes block = noise(format, random);
            const BlockFields fields = fieldsOf(format, block);
            threeColors += hasFourColors(format, fields) ? 0 : 1;
            sixAlphas += format == BlockFormat::Dxt5 && !hasEightAlphas(fields) ? 1 : 0;
            std::array<squish::u8, 64> expected{};
            squish::Decompress(expected.data(), block.data(), squishFlag(format));
            const auto colors = colorsOf(format, fields);
            const auto alphas = alphasOf(format, fields);
            for (std::size_t texel = 0; texel < 16; ++texel) {
                const BlockColor color = colors[fields.indices[texel]];
                for (std::size_t c = 0; c < 3; ++c)
                    ASSERT_EQ(color[c], expected[4 * texel + c]);
                ASSERT_EQ(alphaCount(format) > 0 ? alphas[fields.alphas[texel]] : color[3],
                          expected[4 * texel + 3]);
            }
        }
    EXPECT_GT(threeColors, 100);
    EXPECT_GT(sixAlphas, 100);
}

TEST(BlockParts, TheFourthColorIsTransparentWhereTheFirstEndIsNotLarger) {
    BlockFields fields = fieldsOf(BlockFormat::Dxt1Alpha, redToBlue);
    EXPECT_TRUE(hasFourColors(BlockFormat::Dxt1Alpha, fields));
    EXPECT_THAT(colorsOf(BlockFormat::Dxt1Alpha, fields)[3], ElementsAre(85, 0, 170, 255));
    std::swap(fields.colors[0], fields.colors[1]);
    EXPECT_FALSE(hasFourColors(BlockFormat::Dxt1Alpha, fields));
    EXPECT_THAT(colorsOf(BlockFormat::Dxt1Alpha, fields)[2], ElementsAre(127, 0, 127, 255));
    EXPECT_THAT(colorsOf(BlockFormat::Dxt1Alpha, fields)[3], ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(colorsOf(BlockFormat::Dxt1, fields)[3], ElementsAre(0, 0, 0, 255));
    EXPECT_TRUE(hasFourColors(BlockFormat::Dxt5, fields));
    fields.colors[1] = fields.colors[0]; // equal is not larger
    EXPECT_FALSE(hasFourColors(BlockFormat::Dxt1, fields));
}

// 240 and 16: (6 * 240 + 16) / 7 = 208. 16 and 240: (16 + 4 * 240) / 5 = 195, then 0 and 255.
TEST(BlockParts, AlphasOfDxt5AreEightOrSixWithBothEndsOfTheRange) {
    BlockFields fields;
    fields.alphaEnds = {240, 16};
    EXPECT_EQ(alphasOf(BlockFormat::Dxt5, fields)[2], 208);
    fields.alphaEnds = {16, 240};
    EXPECT_EQ(alphasOf(BlockFormat::Dxt5, fields)[5], 195);
    EXPECT_EQ(alphasOf(BlockFormat::Dxt5, fields)[6], 0);
    EXPECT_EQ(alphasOf(BlockFormat::Dxt5, fields)[7], 255);
}

// 192 is 23 of 31, which is 189; 128 is 32 of 63, which is 130, as 31 of 63 is 125.
TEST(BlockParts, ColorsAreQuantizedToTheNearest) {
    EXPECT_EQ(quantized(192, 128, 255), 23 << 11 | 32 << 5 | 31);
    EXPECT_EQ(quantized(0, 0, 0), 0);
    EXPECT_EQ(quantized(255, 255, 255), 0xFFFF);
    for (int value = 0; value < 65536; value += 7) { // what is one of them already stays as it is
        BlockFields fields;
        fields.colors[0] = static_cast<std::uint16_t>(value);
        const BlockColor color = colorsOf(BlockFormat::Dxt3, fields)[0];
        ASSERT_EQ(quantized(color[0], color[1], color[2]), value);
    }
}

TEST(BlockParts, ATexelGoesWithItsIndexAndItsColor) {
    const BlockFields fields = fieldsOf(BlockFormat::Dxt1, redToBlue);
    const BlockLinks links = linksOf(BlockFormat::Dxt1, fields, {Kind::Texel, 15});
    EXPECT_EQ(links.texels, 1U << 15);
    EXPECT_EQ(links.colors, 1U << 1);
    EXPECT_EQ(links.fields, 1ULL << 17); // two ends, then the indices
    EXPECT_EQ(links.alphas, 0U);
}

TEST(BlockParts, AColorGoesWithItsTexelsAndItsEnds) {
    const BlockFields fields = fieldsOf(BlockFormat::Dxt1, redToBlue);
    const BlockLinks between = linksOf(BlockFormat::Dxt1, fields, {Kind::Color, 2});
    EXPECT_EQ(between.texels, 1U << 2);
    EXPECT_EQ(between.fields, 1ULL << 4 | 3);
    BlockFields three = fields;
    std::swap(three.colors[0], three.colors[1]);
    const BlockLinks black = linksOf(BlockFormat::Dxt1, three, {Kind::Color, 3});
    EXPECT_EQ(black.fields, 1ULL << 5); // of no end
}

TEST(BlockParts, AnEndGoesWithAllThatIsMadeOfIt) {
    const BlockFields fields = fieldsOf(BlockFormat::Dxt1, redToBlue);
    const BlockLinks links = linksOf(BlockFormat::Dxt1, fields, {Kind::Field, 1});
    EXPECT_EQ(links.fields, 1ULL << 1);
    EXPECT_EQ(links.colors, 0b1110U);
    EXPECT_EQ(links.texels, 1U << 15 | 0b1110U);
}

TEST(BlockParts, WithSixAlphasTheLastTwoAreMadeOfNoEnd) {
    BlockFields fields;
    fields.alphaEnds = {16, 240};
    fields.alphas[3] = 7;
    const BlockLinks opaque = linksOf(BlockFormat::Dxt5, fields, {Kind::Alpha, 7});
    EXPECT_EQ(opaque.texels, 1U << 3);
    EXPECT_EQ(opaque.fields, 1ULL << 5); // two ends, then the alphas
    const BlockLinks end = linksOf(BlockFormat::Dxt5, fields, {Kind::Field, 0});
    EXPECT_EQ(end.alphas, 0b00111101U);
}

TEST(BlockParts, AnotherFormatKeepsColorsAndTheNearestAlphas) {
    const BlockBytes dxt3 = inFormat(redToBlue, BlockFormat::Dxt1Alpha, BlockFormat::Dxt3);
    EXPECT_EQ(hexOf(BlockFormat::Dxt3, dxt3), "FF FF FF FF FF FF FF FF 00 F8 1F 00 E4 00 00 40");
    BlockFields holed = fieldsOf(BlockFormat::Dxt1Alpha, redToBlue);
    std::swap(holed.colors[0], holed.colors[1]);
    const BlockBytes dxt5 =
        inFormat(blockOf(BlockFormat::Dxt1Alpha, holed), BlockFormat::Dxt1Alpha, BlockFormat::Dxt5);
    EXPECT_EQ(texelsOf(BlockFormat::Dxt5, dxt5)[3][3], 0);
    EXPECT_EQ(texelsOf(BlockFormat::Dxt5, dxt5)[2][3], 255);
}

TEST(BlockParts, HexThatIsNoBlockIsSaidInASentence) {
    EXPECT_EQ(blockOfHex(BlockFormat::Dxt1, "00 F8 1F").error().message,
              "a block of DXT1 has 16 digits, found 6");
    EXPECT_EQ(blockOfHex(BlockFormat::Dxt5, "0g").error().message,
              "expected the digits 0 to 9 and A to F for a block of DXT5, found \"g\"");
    EXPECT_EQ(blockOfHex(BlockFormat::Dxt1, "00f81f00e4000040").value(), redToBlue);
}

// One of 16 texels differs by 40 in red: the root of 1600 / 48.
TEST(BlockParts, TheErrorIsARootMeanSquare) {
    std::array<BlockColor, 16> a{};
    std::array<BlockColor, 16> b{};
    b[5] = {40, 0, 0, 30};
    EXPECT_DOUBLE_EQ(rootMeanSquare(a, b, 4, 4, false), std::sqrt(1600.0 / 48));
    EXPECT_DOUBLE_EQ(rootMeanSquare(a, b, 4, 4, true), std::sqrt(2500.0 / 64));
    EXPECT_DOUBLE_EQ(rootMeanSquare(a, b, 4, 1, false), 0);
}

} // namespace
} // namespace texplorer::block_parts_test
