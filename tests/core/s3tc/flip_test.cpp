// Decoding what was flipped is flipping what was decoded: with our decoder, and with libsquish.

#include "tests/core/s3tc/squish_oracle.h"
#include "texplorer/s3tc/block_flip.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace texplorer::flip_test {
namespace {

BlockImage randomBlocks(BlockFormat format, int width, int height, int depth = 1) {
    BlockImage image = BlockImage::uninitialised(format, width, height, depth);
    std::mt19937 random(static_cast<unsigned>(width * 1000 + height * 10 + depth));
    for (std::byte& each : image.blocks)
        each = static_cast<std::byte>(random());
    return image;
}

/// The texel at (x, y) moves to where `flippedX` and `flippedY` say; written out pixel by pixel.
Image flipPixels(const Image& image, bool flippedX, bool flippedY) {
    Image flipped = image;
    for (int z = 0; z < image.depth; ++z)
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                std::ranges::copy(
                    image.at(flippedX ? image.width - 1 - x : x, flippedY ? image.height - 1 - y : y, z),
                    flipped.at(x, y, z).begin());
    return flipped;
}

struct Turn {
    const char* name;
    Result<void> (*turn)(BlockImage&);
    bool x;
    bool y;
};

constexpr std::array turns{
    Turn{"Vertically", flipVertically, false, true},
    Turn{"Horizontally", flipHorizontally, true, false},
    Turn{"HalfTurn", rotateHalfTurn, true, true},
};

class EveryFormatAndTurn : public testing::TestWithParam<std::tuple<EnumRow, Turn>> {
protected:
    [[nodiscard]] static BlockFormat format() {
        return static_cast<BlockFormat>(std::get<0>(GetParam()).value);
    }
    [[nodiscard]] static const Turn& turn() { return std::get<1>(GetParam()); }
    [[nodiscard]] static bool legal(int width, int height) {
        return (!turn().x || flipsWithoutLoss(width)) && (!turn().y || flipsWithoutLoss(height));
    }
};

TEST_P(EveryFormatAndTurn, FlipsWhatTheBlocksShow) {
    for (int height = 1; height <= 20; ++height)
        for (int width = 1; width <= 20; ++width)
            for (const int depth : {1, 3}) {
                if (!legal(width, height))
                    continue;
                const BlockImage image = randomBlocks(format(), width, height, depth);
                BlockImage flipped = image;
                ASSERT_TRUE(turn().turn(flipped));
                ASSERT_EQ(decodeBlocks(flipped), flipPixels(decodeBlocks(image), turn().x, turn().y))
                    << width << " x " << height << " x " << depth;
                ASSERT_TRUE(turn().turn(flipped));
                ASSERT_EQ(flipped, image) << "flipped twice: " << width << " x " << height;
            }
}

TEST_P(EveryFormatAndTurn, FlipsEveryLevelOfAMipChain) {
    for (int level = 0; level < 9; ++level) {
        const int width = std::max(1, 256 >> level);
        const int height = std::max(1, 64 >> level);
        const BlockImage image = randomBlocks(format(), width, height);
        BlockImage flipped = image;
        ASSERT_TRUE(turn().turn(flipped));
        ASSERT_EQ(decodeBlocks(flipped), flipPixels(decodeBlocks(image), turn().x, turn().y)) << level;
    }
}

TEST_P(EveryFormatAndTurn, RefusesOtherExtentsAndChangesNothing) {
    for (int height = 1; height <= 13; ++height)
        for (int width = 1; width <= 13; ++width) {
            if (legal(width, height))
                continue;
            const BlockImage image = randomBlocks(format(), width, height);
            BlockImage refused = image;
            const Result<void> result = turn().turn(refused);
            ASSERT_FALSE(result) << width << " x " << height;
            EXPECT_EQ(result.error().code, ErrorCode::Unsupported);
            EXPECT_EQ(refused, image);
        }
}

/// What libsquish sees in the blocks: a picture, or one for each channel of BC4 and BC5.
std::vector<Image> seenBySquish(const BlockImage& image) {
    switch (image.format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
    case BlockFormat::Dxt3:
    case BlockFormat::Dxt5:
        return {decodeWithSquish(image)};
    case BlockFormat::Bc4:
    case BlockFormat::Bc4Signed: // the codes are where BC4 has them
        return {decodeWithSquish(asDxt5Alpha(image, 0))};
    case BlockFormat::Bc5:
    case BlockFormat::Bc5Signed:
        break;
    }
    return {decodeWithSquish(asDxt5Alpha(image, 0)), decodeWithSquish(asDxt5Alpha(image, 1))};
}

TEST_P(EveryFormatAndTurn, FlipsWhatLibsquishSees) {
    int flips = 0;
    for (int height = 1; height <= 16; ++height)
        for (int width = 1; width <= 16; ++width) {
            const BlockImage image = randomBlocks(format(), width, height);
            BlockImage flipped = image;
            if (!turn().turn(flipped))
                continue;
            std::vector<Image> expected = seenBySquish(image);
            for (Image& each : expected)
                each = flipPixels(each, turn().x, turn().y);
            ASSERT_EQ(seenBySquish(flipped), expected) << width << " x " << height;
            ++flips;
        }
    // 1, 2, 3, 4, 8, 12 and 16 along each axis that is turned around
    EXPECT_EQ(flips, (turn().x ? 7 : 16) * (turn().y ? 7 : 16));
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryFormatAndTurn,
                         testing::Combine(testing::ValuesIn(blockFormatRows), testing::ValuesIn(turns)),
                         [](const auto& test) {
                             return std::string(std::get<0>(test.param).name) + "_" +
                                    std::get<1>(test.param).name;
                         });

Bytes bytesOf(std::initializer_list<int> numbers) {
    Bytes bytes;
    for (const int each : numbers)
        bytes.push_back(static_cast<std::byte>(each));
    return bytes;
}

struct ByHand {
    const char* name;
    BlockFormat format;
    int width;
    int height;
    Bytes before;
    Bytes after;
};

class FlipVertically : public testing::TestWithParam<ByHand> {};

TEST_P(FlipVertically, GivesTheBytesWorkedOutByHand) {
    const ByHand& row = GetParam();
    BlockImage image{row.format, row.width, row.height, 1, row.before};
    ASSERT_TRUE(flipVertically(image));
    EXPECT_EQ(image.blocks, row.after);
}

// A row of colour codes is a byte, of DXT3 alphas two bytes, of 3-bit codes twelve bits: the rows 0xABC,
// 0xDEF, 0x123 and 0x456 are the little-endian bytes BC FA DE 23 61 45.
INSTANTIATE_TEST_SUITE_P(
    Rows, FlipVertically,
    testing::Values(ByHand{"Height1", BlockFormat::Dxt1, 8, 1,
                           bytesOf({1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18}),
                           bytesOf({1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18})},
                    ByHand{"Height2", BlockFormat::Dxt1, 2, 2, bytesOf({1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({1, 2, 3, 4, 6, 5, 7, 8})},
                    ByHand{"Height3", BlockFormat::Dxt1, 3, 3, bytesOf({1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({1, 2, 3, 4, 7, 6, 5, 8})},
                    ByHand{"Height4", BlockFormat::Dxt1, 4, 4, bytesOf({1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({1, 2, 3, 4, 8, 7, 6, 5})},
                    ByHand{"Height8", BlockFormat::Dxt1, 4, 8,
                           bytesOf({1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18}),
                           bytesOf({11, 12, 13, 14, 18, 17, 16, 15, 1, 2, 3, 4, 8, 7, 6, 5})},
                    ByHand{"Dxt3Height2", BlockFormat::Dxt3, 2, 2,
                           bytesOf({0, 1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({2, 3, 0, 1, 4, 5, 6, 7, 1, 2, 3, 4, 6, 5, 7, 8})},
                    ByHand{"Dxt3Height3", BlockFormat::Dxt3, 3, 3,
                           bytesOf({0, 1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({4, 5, 2, 3, 0, 1, 6, 7, 1, 2, 3, 4, 7, 6, 5, 8})},
                    ByHand{"Dxt3Height4", BlockFormat::Dxt3, 4, 4,
                           bytesOf({0, 1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({6, 7, 4, 5, 2, 3, 0, 1, 1, 2, 3, 4, 8, 7, 6, 5})},
                    ByHand{"Dxt5Height1", BlockFormat::Dxt5, 1, 1,
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45, 1, 2, 3, 4, 5, 6, 7, 8})},
                    ByHand{"Dxt5Height2", BlockFormat::Dxt5, 2, 2,
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({9, 7, 0xEF, 0xCD, 0xAB, 0x23, 0x61, 0x45, 1, 2, 3, 4, 6, 5, 7, 8})},
                    ByHand{"Dxt5Height3", BlockFormat::Dxt5, 3, 3,
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({9, 7, 0x23, 0xF1, 0xDE, 0xBC, 0x6A, 0x45, 1, 2, 3, 4, 7, 6, 5, 8})},
                    ByHand{"Dxt5Height4", BlockFormat::Dxt5, 4, 4,
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45, 1, 2, 3, 4, 5, 6, 7, 8}),
                           bytesOf({9, 7, 0x56, 0x34, 0x12, 0xEF, 0xCD, 0xAB, 1, 2, 3, 4, 8, 7, 6, 5})},
                    ByHand{"Bc4Height4", BlockFormat::Bc4, 4, 4,
                           bytesOf({9, 7, 0xBC, 0xFA, 0xDE, 0x23, 0x61, 0x45}),
                           bytesOf({9, 7, 0x56, 0x34, 0x12, 0xEF, 0xCD, 0xAB})}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Flip, SaysWhichExtentItExpected) {
    BlockImage image = randomBlocks(BlockFormat::Dxt5, 4, 6);
    const Result<void> result = flipVertically(image);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().message, "a compressed picture of height 6 can't be flipped without loss: "
                                      "expected 1, 2, 3 or a multiple of 4");
}

TEST(Flip, RefusesBlocksThatDontFillTheImage) {
    for (const Turn& each : turns) {
        BlockImage image = randomBlocks(BlockFormat::Dxt1, 8, 8);
        image.blocks.pop_back();
        const BlockImage before = image;
        const Result<void> result = each.turn(image);
        ASSERT_FALSE(result) << each.name;
        EXPECT_EQ(result.error().code, ErrorCode::Malformed);
        EXPECT_EQ(result.error().message,
                  "a compressed picture of 8 × 8 × 1 texels needs 32 bytes of blocks, there are 31");
        EXPECT_EQ(image, before);
        BlockImage empty{BlockFormat::Dxt1, 0, -4, 1, {}};
        EXPECT_FALSE(each.turn(empty)) << each.name;
    }
}

TEST(SwapFlipped, AgreesWithItsPlainTwin) {
    for (const EnumRow& format : blockFormatRows)
        for (const int rows : {1, 2, 3, 4})
            for (const int columns : {1, 2, 3, 4}) {
                const auto blockFormat = static_cast<BlockFormat>(format.value);
                const BlockFlip flip(blockFormat, rows, columns);
                for (int blocks = 0; blocks < 20; ++blocks) {
                    const std::size_t bytes = static_cast<std::size_t>(blocks) * flip.blockBytes;
                    Bytes wide = randomBlocks(blockFormat, 8 * 20, 4).blocks;
                    Bytes plain = wide;
                    swapFlipped(flip, wide.data(), wide.data() + wide.size() / 2, bytes);
                    swapFlippedPlain(flip, plain.data(), plain.data() + plain.size() / 2, bytes);
                    ASSERT_EQ(wide, plain) << format.name << " " << rows << " " << columns << " " << blocks;
                    swapFlipped(flip, wide.data(), wide.data(), bytes);
                    swapFlippedPlain(flip, plain.data(), plain.data(), bytes);
                    ASSERT_EQ(wide, plain) << "in place: " << format.name << " " << blocks;
                }
            }
}

} // namespace
} // namespace texplorer::flip_test
