#include "tests/support/grey_picture.h"
#include "texplorer/compare/heat_map.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace texplorer::heat_map_test {
namespace {

using testing::ElementsAre;

/// CIE lightness, 0 to 100, of an sRGB colour.
double lightness(std::array<std::uint8_t, 4> color) {
    const auto linear = [](std::uint8_t value) {
        const double v = value / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
    return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

struct Scale {
    const char* name;
    HeatScale scale;
};
class Heat : public testing::TestWithParam<Scale> {};

TEST_P(Heat, RunsFromBlackToBrightWithoutAStepBack) {
    const HeatScale scale = GetParam().scale;
    EXPECT_THAT(heatColor(0, scale), ElementsAre(0, 0, 0, 255));
    double before = 0;
    for (int i = 1; i <= scale.top; ++i) {
        const double now = lightness(heatColor(static_cast<float>(i), scale));
        EXPECT_GE(now, before) << i;
        before = now;
    }
    EXPECT_GT(before, 95);
    EXPECT_EQ(heatColor(300, scale), heatColor(static_cast<float>(scale.top), scale));
    EXPECT_EQ(heatColor(-1, scale), heatColor(0, scale));
    EXPECT_EQ(heatColor(NAN, scale), heatColor(0, scale));
    for (const float difference : {0.5F, 1.0F, 7.0F, 255.0F}) // no tolerance is less than none
        EXPECT_EQ(heatColor(difference, {-3, 255}), heatColor(difference, {0, 255})) << difference;
}

// One sees at a glance whether a pixel is over the tolerance.
TEST_P(Heat, JumpsAtTheTolerance) {
    const auto tolerance = static_cast<float>(GetParam().scale.tolerance);
    const double last = lightness(heatColor(tolerance, GetParam().scale));
    EXPECT_LT(last, 21);
    EXPECT_GT(lightness(heatColor(tolerance + 1, GetParam().scale)), last + 8);
}

INSTANTIATE_TEST_SUITE_P(All, Heat,
                         testing::Values(Scale{"ToleranceOne", {}}, Scale{"ToleranceNone", {0, 255}},
                                         Scale{"Close", {2, 16}}, Scale{"Wide", {20, 200}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(HeatMap, ColorsEachPixelByItsWorstComponent) {
    const Image a = greyPicture(2, 2, {0, 50, 100, 150});
    Image b = greyPicture(2, 2, {0, 51, 105, 150});
    b.at(1, 1)[2] = std::byte{250}; // blue: 100
    const Result<Image> map = heatMap(a, b, {2, 128});
    ASSERT_TRUE(map);
    const auto is = [&](int x, int y, int difference) {
        const auto color = heatColor(static_cast<float>(difference), {2, 128});
        for (std::size_t c = 0; c < 4; ++c)
            EXPECT_EQ(std::to_integer<int>(map->at(x, y)[c]), color[c]) << x << ", " << y;
    };
    is(0, 0, 0);
    is(1, 0, 1);
    is(0, 1, 5);
    is(1, 1, 100);
}

} // namespace
} // namespace texplorer::heat_map_test
