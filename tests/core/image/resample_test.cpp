// Powers of two as gluBuild2DMipmaps chooses them, and scaling by coverage against numbers worked out by
// hand.

#include "texplorer/image/linear_light.h"
#include "texplorer/image/mipmaps.h"
#include "texplorer/image/resample.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::resample_test {
namespace {

Image grey(int width, int height, const std::vector<int>& values) {
    Image made = Image::uninitialised(PixelFormat::Luminance8, width, height);
    std::ranges::transform(values, made.pixels.begin(), [](int c) { return static_cast<std::byte>(c); });
    return made;
}

std::vector<int> valuesOf(const Image& image) {
    std::vector<int> values;
    for (const std::byte b : image.pixels)
        values.push_back(std::to_integer<int>(b));
    return values;
}

TEST(PowerOfTwo, IsTheNearestOnGlusScale) {
    // GLU's nearestPower: the two leading bits decide, 10... goes down, 11... up.
    const std::vector<std::pair<int, int>> expected{
        {1, 1},      {2, 2},      {3, 4},       {4, 4},       {5, 4},     {6, 8},
        {7, 8},      {8, 8},      {11, 8},      {12, 16},     {640, 512}, {767, 512},
        {768, 1024}, {800, 1024}, {1000, 1024}, {1024, 1024}, {95, 64},   {96, 128}};
    for (const auto& [extent, power] : expected)
        EXPECT_EQ(nearestPowerOfTwo(extent), power) << extent;
}

struct ScaleCase {
    const char* name;
    int width, height;
    std::vector<int> from;
    int toWidth, toHeight;
    std::vector<int> to;
};

class Scale : public testing::TestWithParam<ScaleCase> {};

TEST_P(Scale, IsTheAverageOfWhatIsCovered) {
    const ScaleCase& c = GetParam();
    EXPECT_EQ(valuesOf(scaleByCoverage(grey(c.width, c.height, c.from), c.toWidth, c.toHeight)), c.to);
}

INSTANTIATE_TEST_SUITE_P(
    All, Scale,
    testing::Values(ScaleCase{"Half", 4, 1, {10, 20, 30, 50}, 2, 1, {15, 40}},
                    // 3 -> 2: the first covers texel 0 and half of texel 1.
                    ScaleCase{"ThreeToTwo", 3, 1, {30, 60, 90}, 2, 1, {40, 80}},
                    // 3 -> 4: 3/3 of 0; 1/3 of 0 and 2/3 of 1; 2/3 of 1 and 1/3 of 2; 3/3 of 2.
                    ScaleCase{"ThreeToFour", 3, 1, {0, 30, 90}, 4, 1, {0, 20, 50, 90}},
                    ScaleCase{"FiveToFourUpwards", 1, 5, {0, 40, 80, 120, 160}, 1, 4, {8, 56, 104, 152}},
                    ScaleCase{"Same", 2, 2, {1, 2, 3, 4}, 2, 2, {1, 2, 3, 4}},
                    ScaleCase{"Doubled", 2, 1, {7, 9}, 4, 1, {7, 7, 9, 9}},
                    ScaleCase{"RoundsToNearest", 2, 1, {1, 2}, 1, 1, {2}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(PowerOfTwo, LeavesOneAsItIs) {
    const Image board = grey(4, 2, {1, 2, 3, 4, 5, 6, 7, 8});
    EXPECT_EQ(toPowerOfTwo(board), board);
    const Image scaled = toPowerOfTwo(grey(3, 1, {0, 30, 90}));
    EXPECT_EQ(scaled.width, 4);
    EXPECT_EQ(scaled.height, 1);
    EXPECT_TRUE(toPowerOfTwo({}).empty());
}

TEST(PowerOfTwo, ComesBeforeTheLevelsWhereItIsWanted) {
    const MipOptions options{.npot = NpotPolicy::PowerOfTwo};
    const MipChain chain = buildMipChain(grey(6, 3, std::vector<int>(18, 77)), options);
    ASSERT_EQ(chain.size(), 4U);
    EXPECT_EQ(chain[0].width, 8);
    EXPECT_EQ(chain[0].height, 4);
    EXPECT_EQ(chain[3].width, 1);
    for (const Image& level : chain)
        EXPECT_THAT(valuesOf(level), testing::Each(77)) << "the mean stays";
}

// sRGB's curve at 0.5 of the light: 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354, times 255 = 187.5.
TEST(LinearLightTest, BlackAndWhiteGive188) {
    const Image board = grey(2, 2, {0, 255, 255, 0});
    EXPECT_EQ(valuesOf(buildMipChain(board, {.linearLight = true})[1]), std::vector{188});
    EXPECT_EQ(valuesOf(buildMipChain(board)[1]), std::vector{128});
    // A quarter of the light: 1.055 * 0.25^(1/2.4) - 0.055 = 0.5371, times 255 = 136.96.
    EXPECT_EQ(valuesOf(buildMipChain(grey(2, 2, {0, 255, 0, 0}), {.linearLight = true})[1]),
              std::vector{137});
    for (const MipFilter filter : {MipFilter::Triangle, MipFilter::Cubic, MipFilter::Mitchell})
        EXPECT_EQ(valuesOf(buildMipChain(board, {.filter = filter, .linearLight = true})[1]),
                  std::vector{188})
            << rowOf(filter).name;
}

TEST(LinearLightTest, AlphaIsNoLight) {
    Image board = Image::uninitialised(PixelFormat::Rgba8, 2, 1);
    std::ranges::transform(std::array{0, 0, 0, 0, 255, 255, 255, 255}, board.pixels.begin(),
                           [](int c) { return static_cast<std::byte>(c); });
    EXPECT_EQ(valuesOf(buildMipChain(board, {.linearLight = true})[1]), (std::vector{188, 188, 188, 128}));
    const auto triangle =
        valuesOf(buildMipChain(board, {.filter = MipFilter::Triangle, .linearLight = true})[1]);
    EXPECT_EQ(triangle, (std::vector{188, 188, 188, 128}));
}

TEST(LinearLightTest, EveryStoredValueComesBack) {
    const LinearLight& table = LinearLight::table();
    for (std::size_t i = 0; i < 256; ++i)
        EXPECT_EQ(table.stored[table.light[i]], i);
    EXPECT_EQ(table.light[0], 0);
    EXPECT_EQ(table.light[255], 65535);
    EXPECT_EQ(table.light[128], 14146) << "0.21586 of the light, IEC 61966-2-1";
}

class Filters : public testing::TestWithParam<EnumRow> {};

TEST_P(Filters, KeepAPlainColorAndEverySize) {
    const auto filter = static_cast<MipFilter>(GetParam().value);
    for (const bool linearLight : {false, true}) {
        const MipChain chain = buildMipChain(grey(13, 6, std::vector<int>(78, 100)),
                                             {.filter = filter, .linearLight = linearLight});
        ASSERT_EQ(chain.size(), 4U);
        const std::array<std::pair<int, int>, 4> extents{{{13, 6}, {6, 3}, {3, 1}, {1, 1}}};
        for (std::size_t i = 0; i < chain.size(); ++i) {
            EXPECT_EQ(chain[i].width, extents[i].first);
            EXPECT_EQ(chain[i].height, extents[i].second);
            EXPECT_THAT(valuesOf(chain[i]), testing::Each(100));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, Filters, testing::ValuesIn(mipFilterRows), [](const auto& test) {
    std::string name(test.param.label);
    std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
    return name;
});

// An edge through the middle: what tells the filters apart, by how far they reach and whether they ring.
TEST(FilterShapes, DifferAsTheirHelpSays) {
    std::vector<int> edge(32, 50);
    std::fill(edge.begin() + 16, edge.end(), 200);
    const auto next = [&](MipFilter filter) {
        return valuesOf(buildMipChain(grey(32, 1, edge), {.filter = filter})[1]);
    };
    const auto box = next(MipFilter::Box);
    EXPECT_THAT(std::vector(box.begin(), box.begin() + 8), testing::Each(50))
        << "the box does not reach over";
    EXPECT_THAT(std::vector(box.begin() + 8, box.end()), testing::Each(200));
    for (const MipFilter soft : {MipFilter::Triangle, MipFilter::Cubic}) {
        EXPECT_GT(next(soft)[7], 50) << rowOf(soft).name;
        EXPECT_GE(std::ranges::min(next(soft)), 50) << rowOf(soft).name << " does not ring";
        EXPECT_LE(std::ranges::max(next(soft)), 200) << rowOf(soft).name << " does not ring";
    }
    EXPECT_GT(next(MipFilter::Cubic)[7], next(MipFilter::Triangle)[7]) << "the softest";
    EXPECT_LT(std::ranges::min(next(MipFilter::CatmullRom)), 50) << "overshoots";
    EXPECT_LT(std::ranges::min(next(MipFilter::Mitchell)), 50);
    EXPECT_GT(std::ranges::min(next(MipFilter::Mitchell)), std::ranges::min(next(MipFilter::CatmullRom)));
}

} // namespace
} // namespace texplorer::resample_test
