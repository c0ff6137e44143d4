#include "texplorer/image/color_scale.h"
#include "texplorer/reference/false_colors.h"

#include <gmock/gmock.h>

#include <cmath>

namespace texplorer::reference::false_colors_test {
namespace {

using testing::ElementsAre;

TEST(FalseColors, AreBlackWhereMagnifiedAndViridisAbove) {
    EXPECT_THAT(lambdaColor(0, 6), ElementsAre(0, 0, 0, 255));
    EXPECT_THAT(lambdaColor(-3, 6), ElementsAre(0, 0, 0, 255));
    EXPECT_EQ(lambdaColor(3, 6), viridis(0.5F));
    EXPECT_EQ(lambdaColor(6, 6), viridis(1));
    EXPECT_EQ(lambdaColor(9, 6), viridis(1)) << "there is no level beyond the last";
}

TEST(FalseColors, HaveEqualStepsFromOneRatioToItsDouble) {
    EXPECT_EQ(ratioColor(1), viridis(0));
    EXPECT_EQ(ratioColor(2), viridis(0.25F));
    EXPECT_EQ(ratioColor(4), viridis(0.5F));
    EXPECT_EQ(ratioColor(16), viridis(1));
    EXPECT_EQ(ratioColor(INFINITY), viridis(1));
    EXPECT_EQ(ratioColor(0.5F), viridis(0)) << "there is no such ratio";
}

TEST(FalseColors, LeaveTransparentWhatIsNotSampled) {
    LevelMap map;
    map.width = 3;
    map.height = 1;
    map.lastLevel = 4;
    map.pixels = {{}, {.lambda = 2, .ratio = 4}, {.lambda = -1, .ratio = 1}};
    const auto colorAt = [](const Image& image, int x) {
        std::array<std::uint8_t, 4> color{};
        for (std::size_t i = 0; i < 4; ++i)
            color[i] = std::to_integer<std::uint8_t>(image.at(x, 0)[i]);
        return color;
    };
    const Image lambda = falseColors(map, Shown::Lambda);
    EXPECT_THAT(colorAt(lambda, 0), ElementsAre(0, 0, 0, 0));
    EXPECT_EQ(colorAt(lambda, 1), viridis(0.5F));
    EXPECT_THAT(colorAt(lambda, 2), ElementsAre(0, 0, 0, 255));
    const Image ratio = falseColors(map, Shown::Anisotropy);
    EXPECT_THAT(colorAt(ratio, 0), ElementsAre(0, 0, 0, 0));
    EXPECT_EQ(colorAt(ratio, 1), viridis(0.5F));
    EXPECT_EQ(colorAt(ratio, 2), viridis(0));
    map.sampler.baseLevel = 2; // two levels above it
    EXPECT_EQ(colorAt(falseColors(map, Shown::Lambda), 1), viridis(1));
}

TEST(FalseColors, CountLevelsAboveTheBase) {
    LevelMap map;
    EXPECT_EQ(stepsOf(map), 1) << "a scale has two ends";
    map.lastLevel = 7;
    map.sampler.baseLevel = 2;
    EXPECT_EQ(stepsOf(map), 5);
}

} // namespace
} // namespace texplorer::reference::false_colors_test
