#include "texplorer/image/mip_colors.h"
#include "texplorer/image/patterns/pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <set>

namespace texplorer::pattern_test {
namespace {

using Rgba = std::array<int, 4>;

Rgba texel(const Image& image, int x, int y, int z = 0) {
    Rgba color{};
    std::ranges::transform(image.at(x, y, z), color.begin(),
                           [](std::byte b) { return std::to_integer<int>(b); });
    return color;
}

struct Extents {
    const char* name;
    Pattern pattern;
    int width;
    int height;
    int depth;
};

class Patterns : public testing::TestWithParam<Extents> {};

TEST_P(Patterns, HaveTheirSizeAndAreTheSameEachTime) {
    const Image image = drawPattern(GetParam().pattern);
    EXPECT_EQ(image.format, PixelFormat::Rgba8);
    EXPECT_EQ(image.width, GetParam().width);
    EXPECT_EQ(image.height, GetParam().height);
    EXPECT_EQ(image.depth, GetParam().depth);
    EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width * image.height * image.depth * 4));
    EXPECT_EQ(image, drawPattern(GetParam().pattern));
}

bool isCutOut(Pattern pattern) {
    return pattern == Pattern::Tree || pattern == Pattern::LogoOpenGl || pattern == Pattern::LogoMultitexture;
}

TEST_P(Patterns, AreOpaqueExceptForWhatIsCutOut) {
    const Image image = drawPattern(GetParam().pattern);
    std::set<int> alphas;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        alphas.insert(std::to_integer<int>(image.pixels[i]));
    if (isCutOut(GetParam().pattern))
        EXPECT_THAT(alphas, testing::IsSupersetOf({0, 255}));
    else
        EXPECT_THAT(alphas, testing::ElementsAre(255));
}

constexpr Extents allPatterns[] = {
    {"Checker", Pattern::Checker, 64, 64, 1},
    {"CheckerRed", Pattern::CheckerRed, 64, 64, 1},
    {"UvTemplate", Pattern::UvTemplate, 512, 512, 1},
    {"Brick", Pattern::Brick, 256, 256, 1},
    {"BrickHeight", Pattern::BrickHeight, 256, 256, 1},
    {"ColorLine", Pattern::ColorLine, 8, 1, 1},
    {"Tree", Pattern::Tree, 256, 256, 1},
    {"MipColors", Pattern::MipColors, 128, 128, 1},
    {"Marble", Pattern::Marble, 32, 32, 32},
    {"CubeFaces", Pattern::CubeFaces, 512, 384, 1},
    {"Planet", Pattern::Planet, 512, 256, 1},
    {"MirrorBall", Pattern::MirrorBall, 256, 256, 1},
    {"LogoOpenGl", Pattern::LogoOpenGl, 128, 64, 1},
    {"LogoMultitexture", Pattern::LogoMultitexture, 128, 64, 1},
    {"Gradient", Pattern::Gradient, 256, 256, 1},
};
static_assert(std::size(allPatterns) == patternRows.size());

INSTANTIATE_TEST_SUITE_P(All, Patterns, testing::ValuesIn(allPatterns),
                         [](const auto& test) { return std::string(test.param.name); });

struct BoardTexel {
    int i; // row, from the bottom
    int j; // column
    int checker;
    int red;
};

// Worked out by hand from c = ((((i&0x8)==0)^((j&0x8))==0))*255 in checker.c, which is parsed as ((i&8)==0)
// xor ((j&8)==0), and the same with 0x10 for the red channel of texbind.c's second image.
constexpr BoardTexel boardTexels[] = {
    {0, 0, 0, 0},       {0, 7, 0, 0},       {0, 8, 255, 0},     {7, 8, 255, 0},     {8, 0, 255, 0},
    {8, 8, 0, 0},       {0, 15, 255, 0},    {0, 16, 0, 255},    {15, 16, 255, 255}, {16, 16, 0, 0},
    {24, 0, 255, 255},  {31, 32, 255, 255}, {63, 63, 0, 0},     {63, 0, 255, 255},  {0, 63, 255, 255},
    {40, 20, 255, 255}, {47, 47, 0, 0},     {48, 47, 255, 255},
};

TEST(Checkerboards, AreThoseOfTheProgrammingGuide) {
    const Image checker = drawPattern(Pattern::Checker);
    const Image red = drawPattern(Pattern::CheckerRed);
    for (const BoardTexel& at : boardTexels) {
        SCOPED_TRACE(testing::Message() << "i = " << at.i << ", j = " << at.j);
        EXPECT_EQ(texel(checker, at.j, at.i), (Rgba{at.checker, at.checker, at.checker, 255}));
        EXPECT_EQ(texel(red, at.j, at.i), (Rgba{at.red, 0, 0, 255}));
    }
}

/// Around a sphere the left edge meets the right one.
TEST(Planet, HasNoSeam) {
    const Image planet = drawPattern(Pattern::Planet);
    int most = 0;
    int within = 0;
    for (int y = 0; y < planet.height; ++y) {
        for (std::size_t c = 0; c < 3; ++c) {
            most = std::max(most, std::abs(texel(planet, 0, y)[c] - texel(planet, planet.width - 1, y)[c]));
            within = std::max(within, std::abs(texel(planet, 101, y)[c] - texel(planet, 100, y)[c]));
        }
    }
    EXPECT_LE(most, within + 24) << "no further apart than neighbours elsewhere";
}

TEST(Gradient, HasItsPlaceAsItsColor) {
    const Image gradient = drawPattern(Pattern::Gradient);
    EXPECT_EQ(texel(gradient, 0, 0), (Rgba{0, 0, 255, 255}));
    EXPECT_EQ(texel(gradient, 255, 0), (Rgba{255, 0, 128, 255}));
    EXPECT_EQ(texel(gradient, 100, 200), (Rgba{100, 200, 105, 255}));
    EXPECT_EQ(texel(gradient, 255, 255), (Rgba{255, 255, 0, 255}));
}

TEST(ColorLine, HasEightDifferentColors) {
    const Image line = drawPattern(Pattern::ColorLine);
    std::set<Rgba> colors;
    for (int x = 0; x < line.width; ++x)
        colors.insert(texel(line, x, 0));
    EXPECT_EQ(colors.size(), 8U);
}

TEST(MipColors, AreEightAndRepeat) {
    std::set<std::array<std::uint8_t, 4>> colors;
    for (int level = 0; level < 8; ++level) {
        EXPECT_EQ(mipColor(level)[3], 255);
        EXPECT_EQ(mipColor(level + 8), mipColor(level));
        colors.insert(mipColor(level));
    }
    EXPECT_EQ(colors.size(), 8U);
    EXPECT_EQ(mipColor(7), (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
    const auto [red, green, blue, alpha] = mipColor(0);
    EXPECT_EQ(texel(drawPattern(Pattern::MipColors), 100, 3), (Rgba{red, green, blue, alpha}));
    EXPECT_GT(red, 2 * std::max(green, blue));
}

// The mean difference between two neighbouring planes of texels across one axis; `at` wraps around.
double step(const Image& image, int axis, int at) {
    const std::array<int, 3> extents{image.width, image.height, image.depth};
    const auto size = static_cast<std::size_t>(axis);
    double sum = 0;
    int count = 0;
    std::array<int, 3> p{};
    for (p[2] = 0; p[2] < extents[2]; ++p[2])
        for (p[1] = 0; p[1] < extents[1]; ++p[1])
            for (p[0] = 0; p[0] < extents[0]; ++p[0]) {
                if (p[size] != at)
                    continue;
                std::array<int, 3> next = p;
                next[size] = (at + 1) % extents[size];
                const Rgba a = texel(image, p[0], p[1], p[2]);
                const Rgba b = texel(image, next[0], next[1], next[2]);
                for (std::size_t c = 0; c < 3; ++c)
                    sum += std::abs(a[c] - b[c]);
                ++count;
            }
    return sum / count;
}

// The step from the last plane to the first, against the median of the steps inside.
double seam(const Image& image, int axis) {
    const std::array<int, 3> extents{image.width, image.height, image.depth};
    const int last = extents[static_cast<std::size_t>(axis)] - 1;
    std::vector<double> inside;
    for (int at = 0; at < last; ++at)
        inside.push_back(step(image, axis, at));
    std::ranges::nth_element(inside, inside.begin() + last / 2);
    return step(image, axis, last) / inside[static_cast<std::size_t>(last / 2)];
}

Image leftPart(const Image& image, int width) {
    Image part = Image::uninitialised(image.format, width, image.height);
    for (int y = 0; y < image.height; ++y)
        std::copy_n(image.at(0, y).begin(), part.rowBytes(), part.at(0, y).begin());
    return part;
}

TEST(Bricks, TileWithoutASeam) {
    for (const Pattern pattern : {Pattern::Brick, Pattern::BrickHeight}) {
        const Image image = drawPattern(pattern);
        EXPECT_LE(seam(image, 0), 4.0); // joints are rougher than the median of bricks
        EXPECT_LE(seam(image, 1), 4.0);
        EXPECT_GT(seam(leftPart(image, 230), 0), 10.0) << "the measure must notice a wall that is cut off";
    }
}

TEST(Bricks, StandOutAboveTheMortarAndDifferFromEachOther) {
    const Image heights = drawPattern(Pattern::BrickHeight);
    const Image wall = drawPattern(Pattern::Brick);
    // Course 0 covers rows 0 to 31, its first brick columns 0 to 63; the joint is between them.
    EXPECT_GT(texel(heights, 32, 16)[0], texel(heights, 0, 16)[0] + 80);
    EXPECT_GT(texel(heights, 32, 16)[0], texel(heights, 32, 0)[0] + 80);
    EXPECT_LT(texel(heights, 32, 48)[0], texel(heights, 64, 48)[0] - 80)
        << "the next course is shifted by half";
    std::set<Rgba> bricks;
    for (int course = 0; course < 8; course += 2)
        for (int brick = 0; brick < 4; ++brick)
            bricks.insert(texel(wall, brick * 64 + 32, course * 32 + 16));
    EXPECT_GE(bricks.size(), 12U);
}

TEST(Marble, TilesAlongAllThreeAxes) {
    const Image block = drawPattern(Pattern::Marble);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_LE(seam(block, axis), 1.2) << "axis " << axis;
    Image cut = Image::uninitialised(block.format, block.width, block.height, 20);
    std::copy_n(block.pixels.begin(), cut.pixels.size(), cut.pixels.begin());
    EXPECT_GT(seam(cut, 2), 2.0) << "the measure must notice a block that is cut off";
}

TEST(Tree, StandsOnTheLowerEdgeWithItsCrownAbove) {
    const Image tree = drawPattern(Pattern::Tree);
    EXPECT_EQ(texel(tree, 128, 2)[3], 255);
    EXPECT_EQ(texel(tree, 128, 160)[3], 255);
    EXPECT_GT(texel(tree, 128, 160)[1], texel(tree, 128, 160)[0]) << "leaves are green";
    EXPECT_GT(texel(tree, 128, 2)[0], texel(tree, 128, 2)[1]) << "wood is brown";
    for (const auto& [x, y] : {std::pair{0, 0}, {255, 0}, {0, 255}, {255, 255}})
        EXPECT_EQ(texel(tree, x, y)[3], 0);
    EXPECT_NE(texel(tree, 0, 255), (Rgba{0, 0, 0, 0})) << "black would bleed into the outline";
}

TEST(UvTemplate, ArrowsRunAlongTheLowerAndTheLeftEdge) {
    const Image image = drawPattern(Pattern::UvTemplate);
    for (int along = 40; along < 440; along += 20) {
        const Rgba s = texel(image, along, 16);
        const Rgba t = texel(image, 16, along);
        EXPECT_GT(s[0], 2 * std::max(s[1], s[2])) << "s is red at " << along;
        EXPECT_GT(t[1], 2 * std::max(t[0], t[2])) << "t is green at " << along;
    }
    std::set<Rgba> tints;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            tints.insert(texel(image, column * 128 + 120, row * 128 + 123));
    EXPECT_EQ(tints.size(), 16U) << "every cell has its own tint";
}

} // namespace
} // namespace texplorer::pattern_test
