// Levels with a ring of texels around them, drawn by hand.

#include "texplorer/image/border.h"

#include <gtest/gtest.h>

#include <string_view>

namespace texplorer::border_test {
namespace {

/// One byte a texel, bottom row first; slices one after the other.
Image letters(int width, int height, int depth, std::string_view texels) {
    Image image = Image::uninitialised(PixelFormat::Luminance8, width, height, depth);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(texels[i]);
    return image;
}

std::string textOf(const Image& image) {
    std::string text;
    for (const std::byte each : image.pixels)
        text += static_cast<char>(each);
    return text;
}

struct Extents {
    const char* name;
    int width;
    int height;
    int depth;
    int axes;
    bool hasBorder;
};
class BorderExtents : public testing::TestWithParam<Extents> {};

TEST_P(BorderExtents, AreTwoMoreThanAPowerOfTwo) {
    const auto& [name, width, height, depth, axes, hasBorder] = GetParam();
    EXPECT_EQ(hasBorderExtents(width, height, depth, axes), hasBorder);
}

INSTANTIATE_TEST_SUITE_P(
    All, BorderExtents,
    testing::Values(Extents{"Picture", 66, 66, 1, 2, true}, Extents{"Oblong", 130, 18, 1, 2, true},
                    Extents{"Smallest", 3, 3, 1, 2, true}, Extents{"PowersOfTwo", 64, 64, 1, 2, false},
                    Extents{"FourIsAPowerOfTwo", 4, 4, 1, 2, false},
                    Extents{"FourBesideMore", 4, 6, 1, 2, true}, Extents{"OneSideOnly", 66, 64, 1, 2, false},
                    Extents{"TwoHasNoInside", 2, 6, 1, 2, false}, Extents{"Line", 66, 1, 1, 1, true},
                    Extents{"LineOfFour", 4, 1, 1, 1, false}, Extents{"Volume", 6, 6, 10, 3, true},
                    Extents{"FlatVolume", 6, 6, 1, 3, false}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(RepeatEdges, PutsTheOutermostTexelsOnceMoreAroundAnImage) {
    EXPECT_EQ(textOf(repeatEdges(letters(3, 1, 1, "abc"), 1)), "aabcc");
    const Image picture = repeatEdges(letters(2, 2, 1, "abcd"), 2);
    EXPECT_EQ(picture.width, 4);
    EXPECT_EQ(picture.height, 4);
    EXPECT_EQ(textOf(picture), "aabb"
                               "aabb"
                               "ccdd"
                               "ccdd");
    const Image volume = repeatEdges(letters(1, 1, 2, "ab"), 3);
    EXPECT_EQ(textOf(volume), "aaaaaaaaa"
                              "aaaaaaaaa"
                              "bbbbbbbbb"
                              "bbbbbbbbb");
    EXPECT_TRUE(repeatEdges({}, 2).empty());
}

// Inside of 4 x 4 with a border of its own: its sides are averaged along themselves, two texels to one.
TEST(MipPolicyWithBorder, MakesTheBordersOfSmallerLevelsOfTheBorder) {
    const Image base = letters(6, 6, 1,
                               "1aaccq"
                               "e0000i"
                               "e0000i"
                               "g0000k"
                               "g0000k"
                               "7mmoo9");
    const MipChain levels = applyMipPolicyWithBorder(MipPolicy::Generated, base, 2);
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_EQ(levels[0], base);
    EXPECT_EQ(textOf(levels[1]), "1acq"
                                 "e00i"
                                 "g00k"
                                 "7mo9");
    EXPECT_EQ(levels[2].width, 3);
    EXPECT_EQ(textOf(levels[2]), "1bq" // b lies between a and c
                                 "f0j"
                                 "7n9");
}

TEST(MipPolicyWithBorder, RepeatsTheEdgeOfAnyOtherImage) {
    const MipChain levels = applyMipPolicyWithBorder(MipPolicy::Generated, letters(2, 2, 1, "aacc"), 2);
    ASSERT_EQ(levels.size(), 2U);
    EXPECT_EQ(textOf(levels[0]), "aaaaaaaacccccccc");
    EXPECT_EQ(textOf(levels[1]), "bbbbbbbbb");
}

TEST(MipPolicyWithBorder, ColoursTheBorderWithItsLevel) {
    const MipChain levels =
        applyMipPolicyWithBorder(MipPolicy::Colored, Image::uninitialised(PixelFormat::Rgba8, 6, 6), 2);
    ASSERT_EQ(levels.size(), 3U);
    EXPECT_EQ(levels[0].width, 6);
    EXPECT_EQ(levels[1].width, 4);
    for (std::size_t i = 0; i < levels[1].pixels.size(); ++i)
        EXPECT_EQ(levels[1].pixels[i], levels[1].pixels[i % 4]);
}

TEST(MipPolicyWithBorder, LinesAndVolumesHaveThemToo) {
    const MipChain line = applyMipPolicyWithBorder(MipPolicy::Generated, letters(6, 1, 1, "xaaccy"), 1);
    ASSERT_EQ(line.size(), 3U);
    EXPECT_EQ(textOf(line[1]), "xacy");
    EXPECT_EQ(textOf(line[2]), "xby");
    const MipChain volume = applyMipPolicyWithBorder(MipPolicy::None, letters(1, 1, 1, "a"), 3);
    ASSERT_EQ(volume.size(), 1U);
    EXPECT_EQ(volume[0].depth, 3);
}

} // namespace
} // namespace texplorer::border_test
