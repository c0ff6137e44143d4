// Section 3.8.8 of the OpenGL 2.1 specification, worked out by hand.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/lod.h"

#include <gtest/gtest.h>

#include <limits>

namespace texplorer::reference::lod_test {
namespace {

using namespace test;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct Case {
    const char* name;
    float texelsX = 1;
    float texelsY = 1;
    MinFilter min = MinFilter::LinearMipmapLinear;
    MagFilter mag = MagFilter::Linear;
    SampleOptions options = {};
    float bias = 0; ///< of the texture object
    float minLod = -1000;
    float maxLod = 1000;
    int base = 0;
    int max = 1000;
    float anisotropy = 1;
    float lambda = 0;
    bool magnified = false;
    int first = 0;
    int second = 0;
    float share = 0;
};

class LevelRule : public testing::TestWithParam<Case> {};

TEST_P(LevelRule, FollowsTheEquations) {
    const Case& row = GetParam();
    SampledTexture texture = leveledTexture(64);
    texture.minFilter = row.min;
    texture.magFilter = row.mag;
    texture.lodBias = row.bias;
    texture.minLod = row.minLod;
    texture.maxLod = row.maxLod;
    texture.baseLevel = row.base;
    texture.maxLevel = row.max;
    texture.maxAnisotropy = row.anisotropy;
    const Lod lod = levelOfDetail(texture, texelsPerPixel(texture, row.texelsX, row.texelsY), row.options);
    EXPECT_NEAR(lod.lambda, row.lambda, 1e-5F);
    EXPECT_EQ(lod.magnified, row.magnified);
    const LevelChoice choice = chooseLevels(texture, lod);
    EXPECT_EQ(choice.first, row.first);
    EXPECT_EQ(choice.second, row.second);
    EXPECT_NEAR(choice.share, row.share, 1e-5F);
}

using M = MinFilter;
const float root8 = std::sqrt(8.0F);

INSTANTIATE_TEST_SUITE_P(
    All, LevelRule,
    testing::Values(
        Case{.name = "One", .magnified = true},
        Case{.name = "TheLongerAxisCounts", .texelsX = 1, .texelsY = 8, .lambda = 3, .first = 3, .second = 4},
        Case{.name = "Between", .texelsX = root8, .lambda = 1.5F, .first = 1, .second = 2, .share = 0.5F},
        Case{.name = "BeyondTheLast", .texelsX = 1024, .lambda = 10, .first = 6, .second = 6},
        // Mesa rounds the maximum anisotropy down to an integer.
        Case{.name = "TheEllipseOfOneAndAHalf",
             .texelsX = 8,
             .texelsY = 2,
             .options = {.anisotropy = AnisotropyMethod::Ellipse},
             .anisotropy = 1.5F,
             .lambda = 3,
             .first = 3,
             .second = 4},
        Case{.name = "TheEllipseOfNearlyThree",
             .texelsX = 8,
             .texelsY = 2,
             .options = {.anisotropy = AnisotropyMethod::Ellipse},
             .anisotropy = 2.9F,
             .lambda = 2,
             .first = 2,
             .second = 3},
        Case{.name = "NoMipmaps", .texelsX = 8, .min = M::Linear, .lambda = 3},
        Case{.name = "NearestRoundsHalfDown",
             .texelsX = root8,
             .min = M::LinearMipmapNearest,
             .lambda = 1.5F,
             .first = 1,
             .second = 1},
        Case{.name = "NearestRoundsUp",
             .texelsX = 3,
             .min = M::LinearMipmapNearest,
             .lambda = 1.5849625F,
             .first = 2,
             .second = 2},
        Case{.name = "NearestStaysAtTheBase",
             .texelsX = 1.25F,
             .min = M::LinearMipmapNearest,
             .lambda = 0.32192809F,
             .first = 0,
             .second = 0},
        Case{.name = "NearestBeyondTheLast",
             .texelsX = 1024,
             .min = M::NearestMipmapNearest,
             .lambda = 10,
             .first = 6,
             .second = 6},
        // c = 1/2 where magnification is linear and minification takes single texels of a mip level
        Case{.name = "SwitchOverMagnifies",
             .texelsX = 1.25F,
             .min = M::NearestMipmapNearest,
             .lambda = 0.32192809F,
             .magnified = true},
        Case{.name = "SwitchOverMinifies",
             .texelsX = 1.5F,
             .min = M::NearestMipmapLinear,
             .lambda = 0.5849625F,
             .first = 0,
             .second = 1,
             .share = 0.5849625F},
        Case{.name = "SwitchOverAtZeroForAll", // OpenGL 4.1, section 3.9.12
             .texelsX = 1.25F,
             .min = M::NearestMipmapNearest,
             .options = {.zeroSwitchOver = true},
             .lambda = 0.32192809F},
        Case{.name = "NoSwitchOverForNearest",
             .texelsX = 1.25F,
             .min = M::NearestMipmapNearest,
             .mag = MagFilter::Nearest,
             .lambda = 0.32192809F},
        Case{.name = "BiasesAddUp",
             .texelsX = 2,
             .options = {.unitBias = 0.5F, .shaderBias = 1},
             .bias = 0.25F,
             .lambda = 2.75F,
             .first = 2,
             .second = 3,
             .share = 0.75F},
        Case{.name = "BiasOfTheTexture", .texelsX = 2, .bias = 2, .lambda = 3, .first = 3, .second = 4},
        // 1 + min(1.5 + 1.5, 2), and not 1 + min(1.5, 2) + min(1.5, 2)
        Case{.name = "TheSumIsClamped",
             .texelsX = 2,
             .options = {.unitBias = 1.5F, .maxBias = 2},
             .bias = 1.5F,
             .lambda = 3,
             .first = 3,
             .second = 4},
        // 1 + (9 - 8), and not 1 + (2 - 2)
        Case{.name = "NeitherIsClampedAlone",
             .texelsX = 2,
             .options = {.unitBias = -8, .maxBias = 2},
             .bias = 9,
             .lambda = 2,
             .first = 2,
             .second = 3},
        Case{.name = "BiasIsClamped",
             .texelsX = 2,
             .options = {.unitBias = 9, .maxBias = 2},
             .lambda = 3,
             .first = 3,
             .second = 4},
        Case{.name = "BiasIsClampedBelow",
             .texelsX = 32,
             .options = {.unitBias = -9, .maxBias = 2},
             .lambda = 3,
             .first = 3,
             .second = 4},
        Case{.name = "BiasThenMaxLod",
             .texelsX = 4,
             .options = {.unitBias = 2},
             .maxLod = 3,
             .lambda = 3,
             .first = 3,
             .second = 4},
        Case{.name = "MinLod", .minLod = 2.5F, .lambda = 2.5F, .first = 2, .second = 3, .share = 0.5F},
        // lambda counts from the base level: 4 texels of level 2 a pixel
        Case{.name = "BaseLevel", .texelsX = 4, .base = 2, .lambda = 2, .first = 4, .second = 5},
        Case{.name = "MaxLevel", .texelsX = 32, .max = 3, .lambda = 5, .first = 3, .second = 3},
        Case{.name = "NothingMoves", .texelsX = 0, .texelsY = 0, .lambda = -1000, .magnified = true},
        // N = ceil(8 / 1), lambda = log2(8 / 8)
        Case{.name = "Anisotropy", .texelsX = 8, .anisotropy = 16, .lambda = 0, .magnified = true},
        Case{.name = "AnisotropyHasALimit",
             .texelsX = 32,
             .anisotropy = 4,
             .lambda = 3,
             .first = 3,
             .second = 4},
        Case{.name = "AnisotropyOfALine",
             .texelsX = 32,
             .texelsY = 0,
             .anisotropy = 4,
             .lambda = 3,
             .first = 3,
             .second = 4},
        // 3e17 times 64 texels a pixel: log2(1.92) + 19 log2(10)
        Case{.name = "SquareTooLarge", .texelsX = 1.92e19F, .lambda = 64.0577401F, .first = 6, .second = 6},
        // N = 3: log2(0.64e19)
        Case{.name = "SquareTooLargeForProbes",
             .texelsX = 1.92e19F,
             .texelsY = 0.64e19F,
             .anisotropy = 16,
             .lambda = 62.4727776F,
             .first = 6,
             .second = 6},
        // log2(1e-30) = -30 log2(10)
        Case{.name = "SquareTooSmall",
             .texelsX = 1e-30F,
             .texelsY = 0,
             .lambda = -99.6578428F,
             .magnified = true},
        Case{.name = "NotANumber", .texelsX = nan, .magnified = true},
        Case{.name = "Infinite", .texelsX = infinity, .magnified = true},
        Case{.name = "BiasNotANumber",
             .texelsX = 4,
             .options = {.unitBias = nan},
             .lambda = 2,
             .first = 2,
             .second = 3},
        Case{.name = "EmptyClamp",
             .texelsX = 4,
             .minLod = 3,
             .maxLod = 1,
             .lambda = 1,
             .first = 1,
             .second = 2}),
    [](const auto& test) { return std::string(test.param.name); });

/// Two texels a pixel, on an image that is turned by 30 degrees; d/dx and d/dy are perpendicular.
Derivatives turned(glm::ivec3 size) {
    constexpr float longer = 1.7320508F; // 2 cos 30
    return {{longer / static_cast<float>(size.x), 1 / static_cast<float>(size.y), 0},
            {-1 / static_cast<float>(size.x), longer / static_cast<float>(size.y), 0}};
}

// Section 3.8.8: max{m_u, m_v} = 2 cos 30 and m_u + m_v = 4 cos 30; the ideal rho, 2, lies between them.
TEST(LevelOfDetail, HasARhoWithinARange) {
    SampledTexture texture = leveledTexture(64);
    const Derivatives derivatives = turned({64, 64, 1});
    struct Row {
        RhoMethod method;
        double rho;
        float lambda;
    };
    for (const auto& [method, rho, lambda] :
         {Row{RhoMethod::Ideal, 2, 1}, Row{RhoMethod::Lower, 1.7320508, 0.792481250F},
          Row{RhoMethod::Upper, 3.4641016, 1.79248125F}}) {
        const Lod lod = levelOfDetail(texture, derivatives, {.rho = method});
        EXPECT_EQ(lod.method, method);
        EXPECT_NEAR(lod.rho, rho, 1e-6);
        EXPECT_NEAR(lod.lambda, lambda, 1e-6F);
    }
    // The extension has its own Px and Py.
    texture.maxAnisotropy = 16;
    for (const RhoMethod method : {RhoMethod::Lower, RhoMethod::Upper})
        EXPECT_NEAR(levelOfDetail(texture, derivatives, {.rho = method}).lambda, 1, 1e-6F);
}

// With m_w, of a volume of 8 x 8 x 8 texels: 4, 3 and 2 texels a pixel, in either direction.
TEST(LevelOfDetail, TakesEveryAxisOfAVolumeIntoTheRange) {
    const Derivatives derivatives{{0.5F, 0, -0.25F}, {0.125F, -0.375F, 0.125F}};
    EXPECT_DOUBLE_EQ(rhoBy(RhoMethod::Lower, derivatives, {8, 8, 8}, 3), 4);
    EXPECT_DOUBLE_EQ(rhoBy(RhoMethod::Upper, derivatives, {8, 8, 8}, 3), 4 + 3 + 2);
    EXPECT_NEAR(rhoBy(RhoMethod::Ideal, derivatives, {8, 8, 8}, 3), 4.47213595, 1e-6); // sqrt(16 + 4)
}

// With one axis there is no choice: m_u is the longer of both lengths.
TEST(LevelOfDetail, HasOneRhoOnALine) {
    const Derivatives derivatives{{0.25F, 9, 9}, {-0.5F, 9, 9}};
    for (const EnumRow& row : rhoMethodRows)
        EXPECT_DOUBLE_EQ(rhoBy(static_cast<RhoMethod>(row.value), derivatives, {64, 1, 1}, 1), 32)
            << row.name;
}

// Sums that do not fit a float.
TEST(LevelOfDetail, HasAnUpperRhoForEveryFiniteDerivative) {
    EXPECT_DOUBLE_EQ(rhoBy(RhoMethod::Upper, {{0x1p127F, 0x1p127F, 0}, {}}, {64, 64, 1}, 2), 0x1p134);
    EXPECT_DOUBLE_EQ(rhoBy(RhoMethod::Upper, {{0x1p-149F, 0x1p-149F, 0}, {}}, {1, 1, 1}, 2), 0x1p-148);
}

// Finite derivatives have a length: squares must not overflow or vanish.
TEST(LevelOfDetail, HoldsForEveryFiniteDerivative) {
    const SampledTexture texture = leveledTexture(64);
    struct Row {
        Derivatives derivatives;
        float lambda;
    };
    const Row rows[] = {
        {{{3e17F, 0, 0}, {}}, 64.0577401F},
        {{{}, {0, -3e17F, 0}}, 64.0577401F},
        {{{3e38F, 0, 0}, {}}, 133.818230F}, // log2(3) + 38 log2(10) + 6, more than a float's largest
        {{{2e38F, -2e38F, 0}, {1, 1, 0}}, 133.733267F}, // log2(2) + 38 log2(10) + 1/2 + 6
        {{{1e-30F, 0, 0}, {}}, -93.6578428F},
        {{{0x1p-149F, 0, 0}, {}}, -143}, // the least number
    };
    for (const Row& row : rows) {
        const Lod lod = levelOfDetail(texture, row.derivatives, {});
        EXPECT_FLOAT_EQ(lod.lambda, row.lambda);
        EXPECT_FALSE(lod.undefined) << row.lambda;
    }
}

// N = ceil(Pmax / Pmin), for any magnitude.
TEST(LevelOfDetail, CountsTheProbesOfEveryFiniteDerivative) {
    SampledTexture texture = leveledTexture(64);
    texture.maxAnisotropy = 16;
    for (const float magnitude : {1e-40F, 1e-30F, 1e-20F, 1.0F, 1e17F, 1e30F, 1e38F}) {
        EXPECT_EQ(levelOfDetail(texture, {{2.5F * magnitude, 0, 0}, {0, magnitude, 0}}, {}).probes, 3)
            << magnitude;
        EXPECT_EQ(levelOfDetail(texture, {{magnitude, 0, 0}, {}}, {}).probes, 16) << magnitude;
    }
}

// Equation 3.25, whose limits are inequalities: up to 1/2 the base level, up to 3/2 the first one after it.
TEST(LevelChoice, TakesTheLowerLevelHalfWayAndNoFurther) {
    SampledTexture texture = leveledTexture(64);
    texture.minFilter = MinFilter::LinearMipmapNearest;
    for (int below = 0; below < 6; ++below) {
        const float half = static_cast<float>(below) + 0.5F;
        const auto levelAt = [&](float lambda) {
            texture.minLod = lambda; // this sets lambda, as one texel per pixel has lambda 0
            return chooseLevels(texture, levelOfDetail(texture, texelsPerPixel(texture, 1, 1), {})).first;
        };
        EXPECT_EQ(levelAt(std::nextafter(half, 0.0F)), below);
        EXPECT_EQ(levelAt(half), below);
        EXPECT_EQ(levelAt(std::nextafter(half, 100.0F)), below + 1);
    }
}

TEST(LevelOfDetail, SaysWhereItIsUndefined) {
    SampledTexture texture = leveledTexture(8);
    EXPECT_FALSE(levelOfDetail(texture, texelsPerPixel(texture, 2, 2), {}).undefined);
    EXPECT_TRUE(levelOfDetail(texture, texelsPerPixel(texture, nan, 2), {}).undefined);
    texture.minLod = 2;
    texture.maxLod = 1;
    EXPECT_TRUE(levelOfDetail(texture, texelsPerPixel(texture, 2, 2), {}).undefined);
}

} // namespace
} // namespace texplorer::reference::lod_test
