// What is done to a picture before it is uploaded. The numbers are worked out by hand; the driver's own pixel
// transfer is asked in tests/render/preparation_test.cpp.

#include "texplorer/image/preparation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace texplorer::preparation_test {
namespace {

using Bytes8 = std::vector<int>;
using enum PixelFormat;

Image imageOf(PixelFormat format, int width, const Bytes8& bytes, int depth = 1) {
    Image image{
        format, width, static_cast<int>(bytes.size()) / bytesPerPixel(format) / width / depth, depth, {}};
    for (const int byte : bytes)
        image.pixels.push_back(static_cast<std::byte>(byte));
    return image;
}

Bytes8 bytesOf(const Image& image) {
    Bytes8 bytes;
    for (const std::byte byte : image.pixels)
        bytes.push_back(std::to_integer<int>(byte));
    return bytes;
}

struct Row {
    const char* name;
    Operation operation;
    PixelFormat format;
    Bytes8 from;
    PixelFormat madeFormat;
    Bytes8 made;
};

class Operations : public testing::TestWithParam<Row> {};

TEST_P(Operations, MakeWhatFollowsByHand) {
    const Row& row = GetParam();
    const Image made =
        prepared(imageOf(row.format, static_cast<int>(row.from.size()) / bytesPerPixel(row.format), row.from),
                 row.operation);
    EXPECT_EQ(made.format, row.madeFormat);
    EXPECT_EQ(bytesOf(made), row.made);
}

Operation scale(glm::vec4 factor, glm::vec4 bias = glm::vec4(0)) {
    return {.op = ImageOp::Scale, .factor = factor, .bias = bias};
}

Operation plain(ImageOp op) {
    return {.op = op};
}

using enum ComponentSource;

Operation swizzle(ComponentSource red, ComponentSource green, ComponentSource blue, ComponentSource alpha) {
    return {.op = ImageOp::Swizzle, .components = {red, green, blue, alpha}};
}

INSTANTIATE_TEST_SUITE_P(
    All, Operations,
    testing::Values(
        // 200 / 2; 51 + 255 * 0.2; 255 * 2 and 10 - 255 leave [0, 1]
        Row{"Scale",
            scale({0.5F, 1, 2, 1}, {0, 0.2F, 0, -1}),
            Rgba8,
            {200, 51, 200, 10},
            Rgba8,
            {100, 102, 255, 0}},
        Row{"ScaleOfOneIsNoChange",
            scale(glm::vec4(1)),
            Rgb8,
            {0, 1, 2, 127, 128, 255},
            Rgb8,
            {0, 1, 2, 127, 128, 255}},
        Row{"ScaleOfAllColoursAlike",
            scale({0.5F, 0.5F, 0.5F, 1}),
            Luminance8,
            {100, 200},
            Luminance8,
            {50, 100}},
        Row{"ScaleMakesGreyColourful", scale({1, 0.5F, 0, 1}), Luminance8, {100}, Rgb8, {100, 50, 0}},
        Row{"ScaleOfAlphaThatIsMissing", scale({1, 1, 1, 0.2F}), Rgb8, {1, 2, 3}, Rgba8, {1, 2, 3, 51}},
        Row{"ScaleOfAnAlphaPicture", scale({9, 9, 9, 0.5F}), Alpha8, {100}, Alpha8, {50}},
        Row{"BiasGivesAnAlphaPictureColour",
            scale(glm::vec4(1), {0.2F, 0.2F, 0.2F, 0}),
            Alpha8,
            {100},
            LuminanceAlpha8,
            {51, 100}},
        Row{"Invert", plain(ImageOp::Invert), Rgba8, {0, 1, 255, 7}, Rgba8, {255, 254, 0, 7}},
        Row{"InvertOfGrey", plain(ImageOp::Invert), LuminanceAlpha8, {3, 4}, LuminanceAlpha8, {252, 4}},
        Row{"InvertLeavesAlphaAlone", plain(ImageOp::Invert), Alpha8, {3}, Alpha8, {3}},
        // 76.245, 149.685, 29.07, 255
        Row{"Luminance",
            plain(ImageOp::Luminance),
            Rgb8,
            {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255},
            Luminance8,
            {76, 150, 29, 255}},
        Row{"LuminanceKeepsAlpha",
            plain(ImageOp::Luminance),
            Rgba8,
            {10, 20, 30, 40},
            LuminanceAlpha8,
            {18, 40}}, // 2.99 + 11.74 + 3.42
        Row{"LuminanceToAlpha",
            plain(ImageOp::LuminanceToAlpha),
            Rgb8,
            {10, 20, 30},
            Rgba8,
            {10, 20, 30, 18}},
        Row{"LuminanceOfGreyToAlpha",
            plain(ImageOp::LuminanceToAlpha),
            Luminance8,
            {77},
            LuminanceAlpha8,
            {77, 77}},
        // 200 * 128 / 255 = 100.4, 100.5 - 0.3, 0.5
        Row{"Premultiply",
            plain(ImageOp::Premultiply),
            Rgba8,
            {200, 100, 1, 128, 255, 9, 3, 0, 7, 8, 9, 255},
            Rgba8,
            {100, 50, 1, 128, 0, 0, 0, 0, 7, 8, 9, 255}},
        Row{"PremultiplyOfGrey",
            plain(ImageOp::Premultiply),
            LuminanceAlpha8,
            {200, 51},
            LuminanceAlpha8,
            {40, 51}},
        Row{"PremultiplyOfTheOpaque", plain(ImageOp::Premultiply), Rgb8, {1, 2, 3}, Rgb8, {1, 2, 3}},
        Row{"PremultiplyOfAlphaAlone", plain(ImageOp::Premultiply), Alpha8, {7}, Alpha8, {7}},
        Row{"SwizzleExchangesRedAndBlue",
            swizzle(Blue, Green, Red, Alpha),
            Rgba8,
            {1, 2, 3, 4},
            Rgba8,
            {3, 2, 1, 4}},
        Row{"SwizzleOfOneComponentIsGrey",
            swizzle(Green, Green, Green, One),
            Rgba8,
            {1, 2, 3, 4},
            Luminance8,
            {2}},
        Row{"SwizzleOfRedToAlpha", swizzle(One, One, One, Red), Rgb8, {9, 2, 3}, LuminanceAlpha8, {255, 9}},
        Row{"SwizzleWithoutColours", swizzle(Zero, Zero, Zero, Alpha), Rgba8, {1, 2, 3, 4}, Alpha8, {4}},
        Row{"SwizzleOfAlphaAlone", swizzle(Red, Green, Blue, Alpha), Alpha8, {7}, Alpha8, {7}},
        Row{"SwizzleOfAlphaToGrey", swizzle(Alpha, Alpha, Alpha, One), Alpha8, {7}, Luminance8, {7}},
        Row{"SwizzleOfGreyStaysGrey", swizzle(Blue, Luminance, Red, Alpha), Luminance8, {7}, Luminance8, {7}},
        Row{"SwizzleToBlack", swizzle(Zero, Zero, Zero, One), Rgb8, {1, 2, 3}, Luminance8, {0}},
        Row{"SwizzleWithLuminance",
            swizzle(Luminance, Zero, One, Luminance),
            Rgb8,
            {10, 20, 30},
            Rgba8,
            {18, 0, 255, 18}},
        // one ring further the mean of 100 and 200
        Row{"Spread",
            plain(ImageOp::Spread),
            LuminanceAlpha8,
            {100, 9, 1, 0, 2, 0, 3, 0, 200, 1},
            LuminanceAlpha8,
            {100, 9, 100, 0, 150, 0, 200, 0, 200, 1}},
        Row{"SpreadOfNothingVisible",
            plain(ImageOp::Spread),
            LuminanceAlpha8,
            {1, 0, 2, 0},
            LuminanceAlpha8,
            {1, 0, 2, 0}},
        Row{"SpreadOfTheOpaque", plain(ImageOp::Spread), Rgb8, {1, 2, 3}, Rgb8, {1, 2, 3}},
        Row{"SpreadOfAlphaAlone", plain(ImageOp::Spread), Alpha8, {0, 7}, Alpha8, {0, 7}},
        Row{"Resize",
            {.op = ImageOp::Resize, .extent = {2, 1, 1}},
            Luminance8,
            {0, 100, 200, 90},
            Luminance8,
            {50, 145}},
        // n / 2 + 1/2 of (0, 0, 1): 127.5, 127.5, 255
        Row{"NormalsOfAPlane",
            plain(ImageOp::Normals),
            Luminance8,
            {70, 70},
            Rgb8,
            {128, 128, 255, 128, 128, 255}},
        // In the middle a slope of 1: 127.5 (1 - 0.7071), 127.5 (1 + 0.7071). At the edges, beyond which the
        // image repeats, -1/2: 127.5 (1 + 0.4472), 127.5 (1 + 0.8944).
        Row{"Normals",
            {.op = ImageOp::Normals, .amount = 2.55F},
            LuminanceAlpha8,
            {0, 1, 100, 2, 200, 3},
            Rgba8,
            {185, 128, 242, 1, 37, 128, 218, 2, 185, 128, 242, 3}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Scale, OfWhatIsNoNumberIsClamped) {
    constexpr float most = std::numeric_limits<float>::max();
    const Image made =
        prepared(imageOf(Rgb8, 1, {0, 255, 1}), scale({most, most, -most, 1}, {0, most, 0, 0}));
    EXPECT_EQ(bytesOf(made), (Bytes8{0, 255, 0}));
}

// 3 x 3 around the middle: 9 texels of which one is 90. Its mean neighbour is 10, so it moves by amount * 80;
// an edge texel counts those beyond the edge as itself.
TEST(Sharpen, MovesAwayFromTheMeanOfTheNeighbours) {
    const Image spot = imageOf(Luminance8, 3, {10, 10, 10, 10, 90, 10, 10, 10, 10});
    const Image made = prepared(spot, {.op = ImageOp::Sharpen, .amount = 0.5F});
    // The corner has the middle once among its neighbours: mean 20, so 10 - 5. So has the edge's middle.
    EXPECT_EQ(bytesOf(made), (Bytes8{5, 5, 5, 5, 130, 5, 5, 5, 5}));
}

TEST(Sharpen, TakesTheNearestTexelBeyondAnEdge) {
    // 0 | 100, one row: the left texel's neighbours are 0 five times and 100 three times.
    const Image made = prepared(imageOf(Luminance8, 2, {40, 80}), {.op = ImageOp::Sharpen, .amount = 1});
    EXPECT_EQ(bytesOf(made), (Bytes8{25, 95})); // 40 - (55 - 40), 80 + (80 - 65)
}

TEST(Sharpen, LeavesAlphaAndOtherSlicesAlone) {
    const Image made = prepared(imageOf(LuminanceAlpha8, 2, {40, 1, 80, 250, 200, 2, 200, 251}, 2),
                                {.op = ImageOp::Sharpen, .amount = 1});
    EXPECT_EQ(bytesOf(made), (Bytes8{25, 1, 95, 250, 200, 2, 200, 251}));
}

TEST(Sharpen, IsTheSumOverEightNeighboursForEachColour) {
    Bytes8 bytes;
    for (unsigned i = 0, state = 1; i < 7 * 5 * 4 * 2; ++i, state = state * 1103515245U + 12345U)
        bytes.push_back(static_cast<int>(state >> 24U));
    const Bytes8 made =
        bytesOf(prepared(imageOf(Rgba8, 7, bytes, 2), {.op = ImageOp::Sharpen, .amount = 0.25F}));
    for (int i = 0; i < 7 * 5 * 4 * 2; ++i) {
        const int c = i % 4;
        const int x = i / 4 % 7;
        const int y = i / 28 % 5;
        const auto near = [&](int across, int up) {
            const int texel = (i / 140 * 5 + std::clamp(y + up, 0, 4)) * 7 + std::clamp(x + across, 0, 6);
            return bytes[static_cast<std::size_t>(4 * texel + c)];
        };
        const int sum = near(-1, -1) + near(0, -1) + near(1, -1) + near(-1, 0) + near(1, 0) + near(-1, 1) +
                        near(0, 1) + near(1, 1);
        const double expected = c == 3 ? near(0, 0) : near(0, 0) + 0.25 * (near(0, 0) - sum / 8.0);
        EXPECT_EQ(made[static_cast<std::size_t>(i)], std::lround(std::clamp(expected, 0.0, 255.0))) << i;
    }
}

TEST(Sharpen, ByNothingIsNoChange) {
    const Image noise = imageOf(Rgb8, 2, {3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8});
    EXPECT_EQ(prepared(noise, {.op = ImageOp::Sharpen, .amount = 0}), noise);
}

TEST(AlphaFrom, IsTheLuminanceOfTheOtherOneAtThisOnesSize) {
    const Image color = imageOf(Rgb8, 2, {1, 2, 3, 4, 5, 6});
    // 4 x 2 texels, of which two by two become one: 0, 0, 100, 100 and 255, 255, 55, 55
    const Image other = imageOf(Luminance8, 4, {0, 0, 255, 255, 100, 100, 55, 55});
    const Image made = prepared(color, {.op = ImageOp::AlphaFrom, .other = &other});
    EXPECT_EQ(made.format, Rgba8);
    EXPECT_EQ(bytesOf(made), (Bytes8{1, 2, 3, 50, 4, 5, 6, 155}));
}

TEST(AlphaFrom, TakesTheAlphaOfAPictureThatHasNoColours) {
    const Image other = imageOf(Alpha8, 1, {33});
    EXPECT_EQ(bytesOf(prepared(imageOf(Luminance8, 1, {9}), {.op = ImageOp::AlphaFrom, .other = &other})),
              (Bytes8{9, 33}));
    EXPECT_EQ(bytesOf(prepared(imageOf(Alpha8, 1, {9}), {.op = ImageOp::AlphaFrom, .other = &other})),
              (Bytes8{33}));
}

TEST(AlphaFrom, OfNoPictureIsNoChange) {
    const Image grey = imageOf(Luminance8, 1, {9});
    const Image none;
    EXPECT_EQ(prepared(grey, plain(ImageOp::AlphaFrom)), grey);
    EXPECT_EQ(prepared(grey, {.op = ImageOp::AlphaFrom, .other = &none}), grey);
}

TEST(Swizzle, PacksComponentsOfTwoImages) {
    const Image image = imageOf(Rgb8, 2, {1, 2, 3, 4, 5, 6});
    // Two texels become one: red 10, green 20 and 40, alpha 30 and 50.
    const Image other = imageOf(Rgba8, 4, {10, 20, 0, 30, 10, 40, 0, 50, 90, 0, 0, 0, 90, 0, 0, 0});
    const Image made = prepared(
        image,
        {.op = ImageOp::Swizzle, .components = {OtherGreen, Blue, OtherAlpha, OtherRed}, .other = &other});
    EXPECT_EQ(made.format, Rgba8);
    EXPECT_EQ(bytesOf(made), (Bytes8{30, 3, 40, 10, 0, 6, 0, 90}));
}

TEST(Swizzle, NeedsTheOtherImageOnlyIfItReadsIt) {
    const Image image = imageOf(Rgb8, 1, {1, 2, 3});
    EXPECT_EQ(prepared(image, swizzle(OtherRed, Green, Blue, Alpha)), image);
    EXPECT_EQ(bytesOf(prepared(image, swizzle(One, Green, Blue, Alpha))), (Bytes8{255, 2, 3}));
}

// 90 and 30 are visible, at two corners. Ring 1 is the mean of those that touch it, and ring 2 of ring 1.
TEST(Spread, GoesRingByRing) {
    const Image image = imageOf(LuminanceAlpha8, 3,
                                {90, 1, 5, 0, 30, 255, //
                                 5, 0, 5, 0, 5, 0,     //
                                 5, 0, 5, 0, 5, 0});
    EXPECT_EQ(bytesOf(prepared(image, plain(ImageOp::Spread))), (Bytes8{90, 1, 60, 0, 30, 255, //
                                                                        90, 0, 60, 0, 30, 0,   //
                                                                        75, 0, 60, 0, 45, 0}));
}

TEST(Spread, StaysInItsSlice) {
    const Image image = imageOf(LuminanceAlpha8, 1, {90, 1, 5, 0}, 2);
    EXPECT_EQ(prepared(image, plain(ImageOp::Spread)), image);
}

TEST(Normals, PointUpWhereHeightsFallUpwards) {
    const Image image = imageOf(Luminance8, 1, {200, 100, 0});
    const Operation operation{.op = ImageOp::Normals, .amount = 2.55F};
    const Bytes8 bytes = bytesOf(prepared(image, operation));
    EXPECT_EQ(Bytes8(bytes.begin() + 3, bytes.begin() + 6), (Bytes8{128, 218, 218}));
    Operation topFirst = operation;
    topFirst.topFirst = true;
    const Bytes8 turned = bytesOf(prepared(image, topFirst));
    EXPECT_EQ(Bytes8(turned.begin() + 3, turned.begin() + 6), (Bytes8{128, 37, 218}));
}

TEST(ImageOps, OfAnEmptyImageStayEmpty) {
    for (const EnumRow& row : imageOpRows)
        EXPECT_TRUE(prepared(Image{}, plain(static_cast<ImageOp>(row.value))).empty()) << row.name;
}

TEST(ImageOps, AreRowsWithNamesOfTheirOwn) {
    std::set<std::string_view> names;
    for (const EnumRow& row : EnumTable<ImageOp>::rows)
        EXPECT_TRUE(names.insert(row.name).second && !row.help.empty()) << row.name;
    EXPECT_EQ(rowOf(ImageOp::AlphaFrom).name, "alpha-from");
}

} // namespace
} // namespace texplorer::preparation_test
