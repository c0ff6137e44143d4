#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/image/mip_colors.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/patterns/pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace texplorer::mipmaps_test {
namespace {

Image image(PixelFormat format, int width, int height, int depth, const std::vector<int>& components) {
    Image made = Image::uninitialised(format, width, height, depth);
    EXPECT_EQ(made.pixels.size(), components.size());
    std::ranges::transform(components, made.pixels.begin(), [](int c) { return static_cast<std::byte>(c); });
    return made;
}

Image randomImage(PixelFormat format, int width, int height, int depth = 1) {
    Image made = Image::uninitialised(format, width, height, depth);
    std::mt19937 random(7); // NOLINT: the same picture each time
    std::ranges::generate(made.pixels, [&] { return static_cast<std::byte>(random() >> 24); });
    return made;
}

std::vector<int> components(const Image& from) {
    std::vector<int> values;
    for (const std::byte b : from.pixels)
        values.push_back(std::to_integer<int>(b));
    return values;
}

struct SmallCase {
    const char* name;
    PixelFormat format;
    int width, height, depth;
    std::vector<int> base;
    std::vector<int> next;
};

class SmallMips : public testing::TestWithParam<SmallCase> {};

TEST_P(SmallMips, AreTheAverageWorkedOutByHand) {
    const SmallCase& c = GetParam();
    const MipChain chain = buildMipChain(image(c.format, c.width, c.height, c.depth, c.base));
    ASSERT_GE(chain.size(), 2U);
    EXPECT_EQ(components(chain[1]), c.next);
    EXPECT_EQ(chain[1].format, c.format);
}

constexpr auto grey = PixelFormat::Luminance8;

INSTANTIATE_TEST_SUITE_P(
    All, SmallMips,
    testing::Values(
        // (10 + 20 + 30 + 41) / 4 = 25.25
        SmallCase{"TwoByTwo", grey, 2, 2, 1, {10, 20, 30, 41}, {25}},
        // 102 / 4 = 25.5 rounds up
        SmallCase{"HalfRoundsUp", grey, 2, 2, 1, {10, 20, 30, 42}, {26}},
        SmallCase{"WhiteStaysWhite", grey, 2, 2, 1, {255, 255, 255, 255}, {255}},
        SmallCase{"RgbaEachComponentAlone",
                  PixelFormat::Rgba8,
                  2,
                  2,
                  1,
                  {0, 4, 255, 8, 2, 4, 255, 0, 4, 8, 255, 0, 6, 8, 254, 0},
                  {3, 6, 255, 2}},
        SmallCase{"Line", grey, 4, 1, 1, {0, 10, 100, 200}, {5, 150}},
        SmallCase{"Column", grey, 1, 4, 1, {0, 10, 100, 200}, {5, 150}},
        // three texels a third each: (10 + 20 + 60) / 3
        SmallCase{"ThreeToOne", grey, 3, 1, 1, {10, 20, 60}, {30}},
        // 5 -> 2: (2 * 10 + 2 * 20 + 30) / 5 = 18 and (30 + 2 * 40 + 2 * 55) / 5 = 44
        SmallCase{"FiveToTwo", grey, 5, 1, 1, {10, 20, 30, 40, 55}, {18, 44}},
        // 7 -> 3, weights 3 3 1 / 2 3 2 / 1 3 3 of 7
        SmallCase{"SevenToThree", grey, 7, 1, 1, {7, 14, 21, 28, 35, 42, 49}, {12, 28, 44}},
        // odd by odd: the mean of all nine is 5
        SmallCase{"ThreeByThree", grey, 3, 3, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {5}},
        // even by odd: 2 x 3 -> 1 x 1: 63 / 6 = 10.5
        SmallCase{"TwoByThree", grey, 2, 3, 1, {0, 3, 10, 20, 10, 20}, {11}},
        SmallCase{"RgbOddLine", PixelFormat::Rgb8, 3, 1, 1, {3, 0, 255, 6, 0, 255, 9, 3, 255}, {6, 1, 255}},
        SmallCase{"LuminanceAlpha", PixelFormat::LuminanceAlpha8, 2, 1, 1, {0, 255, 100, 0}, {50, 128}},
        // a volume: (1 + ... + 8) / 8 = 4.5
        SmallCase{"Volume", grey, 2, 2, 2, {1, 2, 3, 4, 5, 6, 7, 8}, {5}},
        SmallCase{"RgbaVolume",
                  PixelFormat::Rgba8,
                  2,
                  1,
                  2,
                  {0, 0, 0, 0, 4, 8, 12, 255, 4, 8, 12, 255, 8, 16, 24, 255},
                  {4, 8, 12, 191}},
        SmallCase{"OddDepth", grey, 1, 1, 3, {10, 20, 60}, {30}}),
    [](const auto& test) { return std::string(test.param.name); });

struct Extents {
    const char* name;
    int width, height, depth;
    std::vector<std::array<int, 3>> levels;
};

class MipExtents : public testing::TestWithParam<Extents> {};

TEST_P(MipExtents, HalveAndRoundDownUntilOneTexelIsLeft) {
    const Extents& c = GetParam();
    const MipChain chain = buildMipChain(randomImage(PixelFormat::Luminance8, c.width, c.height, c.depth));
    EXPECT_EQ(mipLevelCount(c.width, c.height, c.depth), static_cast<int>(c.levels.size()));
    std::vector<std::array<int, 3>> extents;
    for (const Image& level : chain)
        extents.push_back({level.width, level.height, level.depth});
    EXPECT_EQ(extents, c.levels);
}

INSTANTIATE_TEST_SUITE_P(
    All, MipExtents,
    testing::Values(Extents{"One", 1, 1, 1, {{1, 1, 1}}},
                    Extents{"Wide", 8, 2, 1, {{8, 2, 1}, {4, 1, 1}, {2, 1, 1}, {1, 1, 1}}},
                    Extents{"Odd", 5, 7, 1, {{5, 7, 1}, {2, 3, 1}, {1, 1, 1}}},
                    Extents{"Deep", 3, 1, 9, {{3, 1, 9}, {1, 1, 4}, {1, 1, 2}, {1, 1, 1}}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Mips, OfAnEmptyImageAreNone) {
    EXPECT_TRUE(buildMipChain({}).empty());
    for (const EnumRow& policy : mipPolicyRows)
        EXPECT_TRUE(applyMipPolicy(static_cast<MipPolicy>(policy.value), {}).empty()) << policy.name;
    EXPECT_EQ(mipLevelCount(0, 0), 0);
    EXPECT_EQ(mipLevelCount(16384, 1), 15);
}

double mean(const Image& from, std::size_t component) {
    const auto stride = static_cast<std::size_t>(bytesPerPixel(from.format));
    double sum = 0;
    for (std::size_t i = component; i < from.pixels.size(); i += stride)
        sum += std::to_integer<int>(from.pixels[i]);
    return sum * static_cast<double>(stride) / static_cast<double>(from.pixels.size());
}

// Each level rounds to within 0.5, without bias: after n levels the mean can't have moved by more than n / 2.
TEST(Mips, KeepTheMeanColorOfAnySize) {
    for (const auto& [width, height, depth] : {std::array{37, 23, 1}, {1, 127, 1}, {100, 75, 1}, {11, 6, 13}})
        for (const PixelFormat format : {PixelFormat::Rgba8, PixelFormat::Rgb8, PixelFormat::Alpha8}) {
            const MipChain chain = buildMipChain(randomImage(format, width, height, depth));
            for (std::size_t c = 0; c < static_cast<std::size_t>(bytesPerPixel(format)); ++c)
                for (std::size_t level = 1; level < chain.size(); ++level)
                    EXPECT_NEAR(mean(chain[level], c), mean(chain[0], c), 0.5 * static_cast<double>(level))
                        << width << " x " << height << " x " << depth << ", level " << level;
        }
}

TEST(Mips, OfPowersOfTwoAreThoseOfPillow) {
    const test::TempDir folder;
    for (const auto& [format, mode] : {std::pair{PixelFormat::Rgba8, "RGBA"},
                                       {PixelFormat::Rgb8, "RGB"},
                                       {PixelFormat::Luminance8, "L"}}) {
        const MipChain chain = buildMipChain(randomImage(format, 64, 32));
        for (std::size_t level = 0; level < chain.size(); ++level)
            test::writeRaw(folder / (std::string(mode) + "_" + std::to_string(level) + "_" +
                                     std::to_string(chain[level].width) + "x" +
                                     std::to_string(chain[level].height) + ".raw"),
                           chain[level].pixels);
    }
    EXPECT_TRUE(test::runPython("core/image/mips_against_pillow.py", folder.path()));
}

TEST(MipPolicies, MakeTheChainsThatTheirNamesSay) {
    const Image board = drawPattern(Pattern::Checker);
    EXPECT_THAT(applyMipPolicy(MipPolicy::None, board), testing::ElementsAre(board));
    EXPECT_EQ(applyMipPolicy(MipPolicy::Generated, board), buildMipChain(board));

    const MipChain colored = applyMipPolicy(MipPolicy::Colored, board);
    ASSERT_EQ(colored.size(), 7U);
    EXPECT_EQ(colored[0], board);
    for (int level = 1; level < 7; ++level) {
        const Image& flat = colored[static_cast<std::size_t>(level)];
        EXPECT_EQ(flat.width, 64 >> level);
        const auto color = mipColor(level);
        for (int y = 0; y < flat.height; ++y)
            for (int x = 0; x < flat.width; ++x)
                ASSERT_TRUE(std::ranges::equal(flat.at(x, y), std::as_bytes(std::span(color)))) << level;
    }
}

TEST(MipPolicies, ColoredLevelsAreRgbaWhateverTheBaseIs) {
    const MipChain colored = applyMipPolicy(MipPolicy::Colored, randomImage(PixelFormat::Rgb8, 5, 3, 2));
    ASSERT_EQ(colored.size(), 3U);
    EXPECT_EQ(colored[1].format, PixelFormat::Rgba8);
    EXPECT_EQ(colored[1].pixels.size(), 2U * 1 * 1 * 4);
}

} // namespace
} // namespace texplorer::mipmaps_test
