// Section 3.8.7 of the OpenGL 2.1 specification, worked out by hand for 4 texels.

#include "texplorer/reference/sampling/wrap.h"

#include <gtest/gtest.h>

#include <limits>

namespace texplorer::reference::wrap_test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Case {
    const char* name;
    Wrap wrap;
    float s;
    float u;
    int nearest;
    int first; // of the linear pair
    int second;
    float share;
};

class WrapRule : public testing::TestWithParam<Case> {};

TEST_P(WrapRule, ChoosesTheTexels) {
    const Case& row = GetParam();
    const float u = wrapCoordinate(row.wrap, row.s, 4);
    EXPECT_FLOAT_EQ(u, row.u);
    EXPECT_EQ(nearestTexel(u, 4), row.nearest);
    const TexelPair pair = linearTexels(row.wrap, u, 4);
    EXPECT_EQ(pair.first, row.first);
    EXPECT_EQ(pair.second, row.second);
    EXPECT_FLOAT_EQ(pair.share, row.share);
}

using W = Wrap;
INSTANTIATE_TEST_SUITE_P(
    All, WrapRule,
    testing::Values(Case{"RepeatInside", W::Repeat, 0.3125F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"RepeatBelow", W::Repeat, -0.6875F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"RepeatAbove", W::Repeat, 7.3125F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"RepeatLeftRimMeetsRight", W::Repeat, 0.0625F, 0.25F, 0, 3, 0, 0.75F},
                    Case{"RepeatRightRimMeetsLeft", W::Repeat, 0.9375F, 3.75F, 3, 3, 0, 0.25F},
                    Case{"RepeatOne", W::Repeat, 1, 0, 0, 3, 0, 0.5F},
                    // 1 - 2^-26 is no float: the fraction rounds to 1, which still is the last texel.
                    Case{"RepeatJustBelowZero", W::Repeat, -1.0e-8F, 4, 3, 3, 0, 0.5F},
                    Case{"MirrorInside", W::MirroredRepeat, 0.3125F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"MirrorBelow", W::MirroredRepeat, -0.3125F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"MirrorAbove", W::MirroredRepeat, 1.6875F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"MirrorTwo", W::MirroredRepeat, 2, 0.5F, 0, 0, 1, 0},
                    Case{"MirrorOne", W::MirroredRepeat, 1, 3.5F, 3, 3, 4, 0},
                    Case{"EdgeInside", W::ClampToEdge, 0.3125F, 1.25F, 1, 0, 1, 0.75F},
                    Case{"EdgeBelow", W::ClampToEdge, -3, 0.5F, 0, 0, 1, 0},
                    Case{"EdgeAbove", W::ClampToEdge, 3, 3.5F, 3, 3, 4, 0},
                    Case{"BorderBelow", W::ClampToBorder, -3, -0.5F, -1, -1, 0, 0},
                    Case{"BorderAbove", W::ClampToBorder, 3, 4.5F, 4, 4, 5, 0},
                    Case{"BorderOnTheRim", W::ClampToBorder, 1, 4, 3, 3, 4, 0.5F},
                    // Half of what lies on the rim is border: the half border of GL_CLAMP.
                    Case{"ClampBelow", W::Clamp, -3, 0, 0, -1, 0, 0.5F},
                    Case{"ClampAbove", W::Clamp, 3, 4, 3, 3, 4, 0.5F},
                    Case{"NotANumber", W::ClampToEdge, nan, 0.5F, 0, 0, 1, 0},
                    Case{"Infinite", W::Repeat, infinity, 0, 0, 3, 0, 0.5F},
                    Case{"MinusInfinite", W::Clamp, -infinity, 0, 0, -1, 0, 0.5F},
                    Case{"Huge", W::ClampToBorder, 3e38F, 4.5F, 4, 4, 5, 0},
                    Case{"HugeMirrored", W::MirroredRepeat, -3e38F, 0.5F, 0, 0, 1, 0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FloorToInt, IsDefinedForEveryFloat) {
    EXPECT_EQ(floorToInt(-0.5F), -1);
    EXPECT_EQ(floorToInt(2.999F), 2);
    EXPECT_EQ(floorToInt(1e20F), 1 << 30);
    EXPECT_EQ(floorToInt(-infinity), -(1 << 30));
    EXPECT_EQ(floorToInt(nan), 0);
}

} // namespace
} // namespace texplorer::reference::wrap_test
