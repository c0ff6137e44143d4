// The quality of palettes compared with ImageMagick's: tests/end_to_end/texshot/animate_test.py.

#include "texplorer/animation/palette.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace texplorer::animation::palette_test {
namespace {

using testing::ElementsAre;

TEST(PaletteFor, IsThePixelsOwnColoursWhereThatIsEnough) {
    const std::vector<std::uint32_t> pixels{0xFF0000FF, 0xFF00FF00, 0xFF0000FF, 0xFF000000};
    EXPECT_THAT(paletteFor(pixels, 3), ElementsAre(0xFF000000, 0xFF0000FF, 0xFF00FF00));
    EXPECT_THAT(paletteFor(pixels, 256).size(), 3U);
    EXPECT_TRUE(paletteFor({}, 256).empty());
}

TEST(PaletteFor, IsTheMeanOfEachCluster) {
    // Red 10, 20 and 30, the last one twice; and a blue far away from them.
    const std::vector<std::uint32_t> pixels{0xFF0A0000, 0xFF140000, 0xFF1E0000,
                                            0xFF1E0000, 0xFF0000F0, 0xFF0000F2};
    EXPECT_THAT(paletteFor(pixels, 2), ElementsAre(0xFF0000F1, 0xFF170000)); // 22.5, rounded
}

TEST(PaletteFor, CoversARampEvenly) {
    std::vector<std::uint32_t> ramp;
    for (std::uint32_t i = 0; i < 256; ++i)
        ramp.push_back(0xFF000000U | i << 16U | i << 8U | i);
    const Palette palette = paletteFor(ramp, 16);
    ASSERT_EQ(palette.size(), 16U);
    for (const std::uint32_t pixel : ramp) { // 16 equal parts would be at most 8 away
        const auto grey = static_cast<int>(pixel & 0xFFU);
        EXPECT_TRUE(std::ranges::any_of(palette, [&](std::uint32_t each) {
            return std::abs(static_cast<int>(each & 0xFFU) - grey) <= 12;
        })) << grey;
    }
}

TEST(NearestColor, IsWhatASearchFinds) {
    std::mt19937 random(3);
    Palette palette;
    for (int i = 0; i < 200; ++i)
        palette.push_back(0xFF000000U | (static_cast<std::uint32_t>(random()) & 0xFFFFFFU));
    NearestColor nearest(palette);
    const auto distance = [&](std::size_t index, int r, int g, int b) {
        const std::uint32_t color = palette[index];
        const int red = static_cast<int>(color >> 16U & 0xFFU) - r;
        const int green = static_cast<int>(color >> 8U & 0xFFU) - g;
        const int blue = static_cast<int>(color & 0xFFU) - b;
        return std::sqrt(static_cast<double>(red * red + green * green + blue * blue));
    };
    for (int i = 0; i < 2000; ++i) {
        const int r = static_cast<int>(random() % 256);
        const int g = static_cast<int>(random() % 256);
        const int b = static_cast<int>(random() % 256);
        double least = 1e9;
        for (std::size_t each = 0; each < palette.size(); ++each)
            least = std::min(least, distance(each, r, g, b));
        // The colour of the middle of its cell, which is at most sqrt(12) away: twice that further than the
        // best.
        EXPECT_LE(distance(nearest.of(r, g, b), r, g, b), least + 2 * std::sqrt(12.0));
    }
}

} // namespace
} // namespace texplorer::animation::palette_test
