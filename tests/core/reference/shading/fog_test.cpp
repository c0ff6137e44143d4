// Section 3.10 of the OpenGL 2.1 specification, worked out by hand.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/shading/fog.h"

#include <gmock/gmock.h>

#include <limits>

namespace texplorer::reference::fog_test {
namespace {

using namespace test;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Case {
    const char* name;
    FogMode mode;
    float density;
    float start;
    float end;
    float distance;
    float factor;
};
class FogFactor : public testing::TestWithParam<Case> {};

TEST_P(FogFactor, IsThatOfTheEquation) {
    const Case& row = GetParam();
    const Fog fog{true, row.mode, row.density, row.start, row.end, {}};
    EXPECT_NEAR(fogFactor(fog, row.distance), row.factor, 1e-6F);
}

INSTANTIATE_TEST_SUITE_P(
    All, FogFactor,
    testing::Values(Case{"LinearHalfWay", FogMode::Linear, 9, 2, 6, 4, 0.5F},
                    Case{"LinearAtTheStart", FogMode::Linear, 9, 2, 6, 2, 1},
                    Case{"LinearBeforeTheStart", FogMode::Linear, 9, 2, 6, 0.5F, 1},
                    Case{"LinearAtTheEnd", FogMode::Linear, 9, 2, 6, 6, 0},
                    Case{"LinearBeyondTheEnd", FogMode::Linear, 9, 2, 6, 100, 0},
                    Case{"LinearFromBehindTheEye", FogMode::Linear, 9, -4, 12, 4, 0.5F},
                    Case{"LinearBackwards", FogMode::Linear, 9, 6, 2, 3, 0.25F},
                    Case{"LinearWithoutLengthBefore", FogMode::Linear, 9, 3, 3, 2, 1},
                    Case{"LinearWithoutLengthBeyond", FogMode::Linear, 9, 3, 3, 4, 0},
                    Case{"LinearWithoutLengthThere", FogMode::Linear, 9, 3, 3, 3, 0},
                    Case{"ExpNowhere", FogMode::Exp, 0.5F, 2, 6, 0, 1},
                    Case{"Exp", FogMode::Exp, 0.5F, 2, 6, 2, 0.3678794F},        // 1 / e
                    Case{"ExpFarther", FogMode::Exp, 0.5F, 2, 6, 4, 0.1353353F}, // 1 / e^2
                    Case{"ExpWithoutDensity", FogMode::Exp, 0, 2, 6, 1000, 1},
                    Case{"ExpTooFar", FogMode::Exp, 1000, 2, 6, 1000, 0},
                    Case{"Exp2", FogMode::Exp2, 0.5F, 2, 6, 2, 0.3678794F},
                    Case{"Exp2Farther", FogMode::Exp2, 0.5F, 2, 6, 4, 0.0183156F}, // 1 / e^4
                    Case{"Infinite", FogMode::Exp2, 0.5F, 2, 6, infinity, 0},
                    Case{"NotANumber", FogMode::Exp, 0.5F, 2, 6, nan, 0}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FoggedColor, LeavesAlphaAlone) {
    const Fog fog{.enabled = true, .color = {1, 0, 0.5F, 0}};
    EXPECT_TRUE(isNear(fogged({0.2F, 0.4F, 0.6F, 0.8F}, fog, 0.25F), {0.8F, 0.1F, 0.525F, 0.8F}));
}

TEST(FoggedColor, IsMixedWithAColorThatIsClamped) {
    const Fog fog{.enabled = true, .color = {2, -1, 0.5F, 7}};
    EXPECT_TRUE(isNear(fogged({0.2F, 0.4F, 0.6F, 0.8F}, fog, 0.5F), {0.6F, 0.2F, 0.55F, 0.8F}));
}

TEST(FogEquation, IsWrittenInSymbolsAndInNumbers) {
    using testing::ElementsAre;
    const Equation linear = fogEquation({true, FogMode::Linear, 9, 2, 6, {}}, 5);
    EXPECT_EQ(linear.symbols, "f = (end - c) / (end - start)");
    EXPECT_THAT(linear.numbers, ElementsAre("(6 - 5) / (6 - 2) = 0.25"));
    const Equation exp = fogEquation({true, FogMode::Exp, 0.5F, 2, 6, {}}, 2);
    EXPECT_EQ(exp.symbols, "f = e^(-density * c)");
    EXPECT_THAT(exp.numbers, ElementsAre("e^(-0.5 * 2) = 0.3679"));
    const Equation exp2 = fogEquation({true, FogMode::Exp2, 0.5F, 2, 6, {}}, 4);
    EXPECT_EQ(exp2.symbols, "f = e^(-(density * c)^2)");
    EXPECT_THAT(exp2.numbers, ElementsAre("e^(-(0.5 * 4)^2) = 0.0183"));
}

} // namespace
} // namespace texplorer::reference::fog_test
