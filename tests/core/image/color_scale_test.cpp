#include "texplorer/image/color_scale.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace texplorer::color_scale_test {
namespace {

using testing::ElementsAre;

/// L* of CIE 1976, of an sRGB colour.
double lightness(const std::array<std::uint8_t, 4>& color) {
    const auto linear = [](std::uint8_t value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

// The colours that the map is published with, #440154, #31688e, #35b779 and #fde725 for thirds of its length.
TEST(Viridis, HasThePublishedColors) {
    EXPECT_THAT(viridis(0), ElementsAre(0x44, 0x01, 0x54, 255));
    EXPECT_THAT(viridis(1.0F / 3), ElementsAre(0x31, 0x68, 0x8e, 255));
    EXPECT_THAT(viridis(2.0F / 3), ElementsAre(0x35, 0xb7, 0x79, 255));
    EXPECT_THAT(viridis(1), ElementsAre(0xfd, 0xe7, 0x25, 255));
}

TEST(Viridis, GetsLighterWithEveryStep) {
    double before = -1;
    for (int i = 0; i <= 64; ++i) {
        const double now = lightness(viridis(static_cast<float>(i) / 64));
        EXPECT_GT(now, before) << i;
        before = now;
    }
    EXPECT_LT(lightness(viridis(0)), 20);
    EXPECT_GT(before, 85);
}

TEST(Viridis, EndsAtItsEnds) {
    EXPECT_EQ(viridis(-1), viridis(0));
    EXPECT_EQ(viridis(7), viridis(1));
    EXPECT_EQ(viridis(std::numeric_limits<float>::infinity()), viridis(1));
    EXPECT_EQ(viridis(std::numeric_limits<float>::quiet_NaN()), viridis(0));
}

} // namespace
} // namespace texplorer::color_scale_test
