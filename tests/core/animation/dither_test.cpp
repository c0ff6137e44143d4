#include "texplorer/animation/dither.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace texplorer::animation::dither_test {
namespace {

std::uint32_t grey(std::uint32_t value) {
    return 0xFF000000U | value << 16U | value << 8U | value;
}

/// Every colour of a 64 x 64 picture differs: red with x, green with y.
OpaqueFrame manyColors() {
    OpaqueFrame frame{64, 64, {}};
    for (std::uint32_t y = 0; y < 64; ++y)
        for (std::uint32_t x = 0; x < 64; ++x)
            frame.pixels.push_back(0xFF000000U | x * 4 << 16U | y * 4 << 8U | 0x80U);
    return frame;
}

OpaqueFrame shown(const IndexedPicture& picture, OpaqueFrame before) {
    for (int y = 0; y < picture.rect.height; ++y)
        for (int x = 0; x < picture.rect.width; ++x) {
            const std::uint8_t index = picture.row(y)[x];
            if (picture.nothing != index)
                before.pixels[static_cast<std::size_t>((picture.rect.y + y) * before.width + picture.rect.x +
                                                       x)] = picture.palette.at(index);
        }
    return before;
}

TEST(Indexed, LosesNothingOfFewColours) {
    OpaqueFrame frame{16, 16, {}};
    for (std::uint32_t i = 0; i < 256; ++i)
        frame.pixels.push_back(grey(i));
    const IndexedPicture picture = indexed(frame, nullptr);
    EXPECT_EQ(picture.palette.size(), 256U);
    EXPECT_FALSE(picture.nothing);
    EXPECT_EQ(shown(picture, OpaqueFrame{16, 16, std::vector<std::uint32_t>(256)}), frame);
}

TEST(Indexed, WritesWhatHasChangedAlone) {
    OpaqueFrame before{4, 3, std::vector<std::uint32_t>(12, grey(9))};
    OpaqueFrame now = before;
    now.pixels[1] = now.pixels[4 + 2] = grey(77);
    const IndexedPicture picture = indexed(now, &before);
    EXPECT_EQ(picture.rect, (FrameRect{1, 0, 2, 2}));
    EXPECT_EQ(picture.palette, Palette{grey(77)});
    EXPECT_EQ(picture.nothing, 1);
    EXPECT_EQ(picture.indices, (std::vector<std::uint8_t>{0, 1, 1, 0}));
    const IndexedPicture same = indexed(before, &before);
    EXPECT_EQ(same.rect, (FrameRect{0, 0, 1, 1}));
    EXPECT_EQ(same.indices, (std::vector<std::uint8_t>{*same.nothing}));
}

TEST(Indexed, NeedsNoPlaceForNothingWhereAllHasChanged) {
    const OpaqueFrame before{64, 64, std::vector<std::uint32_t>(64 * 64, grey(1))};
    const OpaqueFrame now = manyColors();
    const IndexedPicture picture = indexed(now, &before);
    EXPECT_FALSE(picture.nothing);
    EXPECT_GT(picture.palette.size(), 200U);
    EXPECT_LE(picture.palette.size(), 256U);
}

// 4096 colours in 256 are 4 x 4 of them each: steps of 16 in two colours, so no pixel is far away, and with
// what goes on to the neighbours the mean of a part of the picture is as it was.
TEST(Indexed, IsNearEverywhereAndRightOnAverage) {
    const OpaqueFrame now = manyColors();
    const OpaqueFrame seen =
        shown(indexed(now, nullptr), OpaqueFrame{64, 64, std::vector<std::uint32_t>(4096)});
    for (int tile = 0; tile < 16; ++tile) {
        double red = 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const auto at = static_cast<std::size_t>((tile / 4 * 16 + y) * 64 + tile % 4 * 16 + x);
                const int difference = static_cast<int>(seen.pixels[at] >> 16U & 0xFFU) -
                                       static_cast<int>(now.pixels[at] >> 16U & 0xFFU);
                EXPECT_LE(std::abs(difference), 40);
                red += difference;
            }
        EXPECT_NEAR(red / 256, 0, 1.5) << tile;
    }
}

TEST(Indexed, GivesTheSameForTheSame) {
    const OpaqueFrame now = manyColors();
    EXPECT_EQ(indexed(now, nullptr).indices, indexed(now, nullptr).indices);
}

} // namespace
} // namespace texplorer::animation::dither_test
