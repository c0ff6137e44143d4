// The filters of OpenGL 2.1, sections 3.8.8 and 3.8.9, worked out by hand.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/sampling/ellipse.h"
#include "texplorer/reference/sampling/sampler.h"

#include <gmock/gmock.h>

#include <limits>

namespace texplorer::reference::sampler_test {
namespace {

using namespace test;

/// Texel i, j, k has i / 10 in red, j / 10 in green, k / 10 in blue.
glm::vec4 indexColor(int i, int j, int k) {
    return glm::vec4(i, j, k, 10) / 10.0F;
}

SampledTexture indexTexture(Target target, glm::ivec3 size, int border = 0) {
    SampledTexture texture;
    texture.target = target;
    texture.levels = {makeLevel(size, indexColor, border, axesOf(target))};
    texture.minFilter = MinFilter::Linear;
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::ClampToEdge;
    texture.borderColor = {0.9F, 0.9F, 0.9F, 0.5F};
    return texture;
}

TEST(Sample, NearestTakesTheTexelThatHoldsThePlace) {
    SampledTexture texture = indexTexture(Target::Texture3D, {4, 2, 8});
    texture.magFilter = MagFilter::Nearest;
    EXPECT_TRUE(isNear(sample(texture, {0.7F, 0.6F, 0.2F}, {}), {0.2F, 0.1F, 0.1F, 1}));
}

// u = 2.25, v = 1.1, w = 4.6: 1.75, 0.6 and 4.1 texels from the first centre
TEST(Sample, LinearBlendsAlongEveryAxisOfTheTarget) {
    const glm::vec3 at{2.25F / 4, 1.1F / 2, 4.6F / 8};
    EXPECT_TRUE(
        isNear(sample(indexTexture(Target::Texture3D, {4, 2, 8}), at, {}), {0.175F, 0.06F, 0.41F, 1}));
    EXPECT_TRUE(isNear(sample(indexTexture(Target::Texture2D, {4, 2, 1}), at, {}), {0.175F, 0.06F, 0, 1}));
    EXPECT_TRUE(isNear(sample(indexTexture(Target::Texture1D, {4, 1, 1}), at, {}), {0.175F, 0, 0, 1}));
}

TEST(Sample, ClampBlendsHalfTheBorderColourIntoTheRim) {
    SampledTexture texture = indexTexture(Target::Texture1D, {4, 1, 1});
    texture.wrapS = Wrap::Clamp;
    EXPECT_TRUE(isNear(sample(texture, {2, 0, 0}, {}), {(0.3F + 0.9F) / 2, 0.45F, 0.45F, 0.75F}));
}

TEST(Sample, BorderTexelsGoBeforeTheBorderColour) {
    SampledTexture texture = indexTexture(Target::Texture2D, {4, 4, 1}, 1);
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::ClampToBorder;
    EXPECT_TRUE(isNear(sample(texture, {-3, 0.375F, 0}, {}), {-0.1F, 0.1F, 0, 1}));
    EXPECT_TRUE(isNear(sample(texture, {3, 3, 0}, {}), {0.4F, 0.4F, 0, 1}));
    texture.wrapS = texture.wrapT = texture.wrapR = Wrap::Clamp;
    EXPECT_TRUE(isNear(sample(texture, {3, 0.375F, 0}, {}), {0.35F, 0.1F, 0, 1}));
}

TEST(Sample, TrilinearBlendsTwoLevels) {
    SampledTexture texture = leveledTexture(16);
    texture.minFilter = MinFilter::LinearMipmapLinear;
    // lambda = log2 3 = 1.585: 0.415 of level 1 (0.1) and 0.585 of level 2 (0.2)
    EXPECT_TRUE(
        isNear(sample(texture, {0.3F, 0.3F, 0}, texelsPerPixel(texture, 3, 1)), {0.1584963F, 0, 0, 1}));
}

// Section 3.8.8: without mipmaps the base level is sampled. Where it is present, GL_TEXTURE_MAX_LEVEL has no
// say.
TEST(Sample, WithoutMipmapsTheBaseLevelIsReadWhateverTheMaximum) {
    SampledTexture texture = leveledTexture(16);
    texture.baseLevel = 2;
    texture.maxLevel = 1;
    for (const MinFilter filter : {MinFilter::Nearest, MinFilter::Linear}) {
        texture.minFilter = filter;
        for (const float texels : {0.25F, 1.0F, 8.0F})
            EXPECT_TRUE(isNear(sample(texture, {0.3F, 0.6F, 0}, texelsPerPixel(texture, texels, texels)),
                               {0.2F, 0, 0, 1}))
                << texels;
    }
}

TEST(Sample, AnisotropyProbesAlongTheLongerAxis) {
    SampledTexture texture = indexTexture(Target::Texture2D, {16, 16, 1});
    texture.maxAnisotropy = 4;
    texture.magFilter = MagFilter::Nearest;
    // Two texels a pixel along s, one along t: N = 2, at u - 1/3 and u + 1/3 of those two texels.
    const SampleRecord record =
        explainSample(texture, {8.0F / 16, 8.5F / 16, 0}, texelsPerPixel(texture, 2, 1));
    EXPECT_EQ(record.lod.probes, 2);
    ASSERT_EQ(record.probes.size(), 2U);
    EXPECT_FLOAT_EQ(record.probes[0].s, (8.0F - 1.0F / 3) / 16);
    EXPECT_FLOAT_EQ(record.probes[1].s, (8.0F + 1.0F / 3) / 16);
    EXPECT_TRUE(isNear(record.color, {0.75F, 0.8F, 0, 1}));
}

TEST(Sample, TheEllipseIsSymmetricAndNormalised) {
    SampledTexture texture = indexTexture(Target::Texture2D, {64, 64, 1});
    texture.maxAnisotropy = 16;
    const SampleRecord record =
        explainSample(texture, {32.5F / 64, 32.5F / 64, 0}, texelsPerPixel(texture, 9, 2),
                      {.anisotropy = AnisotropyMethod::Ellipse});
    EXPECT_TRUE(record.lod.ellipse);
    EXPECT_FLOAT_EQ(record.lod.lambda, 1); // the shorter axis has two texels
    EXPECT_TRUE(isNear(record.color, {3.2F, 3.2F, 0, 1}, 1e-4F));
    // A^2 = 2^2 + 1, C^2 = 9^2 + 1: nine texels to either side are on it, ten are not.
    int left = 32;
    int low = 32;
    for (const Tap& tap : record.taps) {
        left = std::min(left, tap.index.x);
        low = std::min(low, tap.index.y);
    }
    EXPECT_EQ(left, 32 - 9);
    EXPECT_EQ(low, 32 - 2);
}

// 9 by 2 texels: lambda is 1, and the 4.5 texels of level 1 get 5 samples, with linear filters.
TEST(Sample, TheLineIsEvenlySampled) {
    SampledTexture texture = leveledTexture(64);
    texture.maxAnisotropy = 16;
    texture.minFilter = MinFilter::NearestMipmapLinear;
    const SampleRecord record = explainSample(texture, {0.5F, 0.5F, 0}, texelsPerPixel(texture, 9, 2),
                                              {.anisotropy = AnisotropyMethod::Line});
    EXPECT_TRUE(record.lod.line);
    EXPECT_FLOAT_EQ(record.lod.lambda, 1);
    ASSERT_EQ(record.probes.size(), 5U);
    for (int i = 0; i < 5; ++i)
        EXPECT_FLOAT_EQ(record.probes[static_cast<std::size_t>(i)].s,
                        0.5F + 9.0F / 64 * static_cast<float>(i - 2) / 5);
    EXPECT_THAT(record.taps, testing::Each(testing::Field(&Tap::level, 1)));
    EXPECT_EQ(record.taps.size(), 20U) << "2 x 2 texels for each";
}

// Mesa 25 divides by the root of the maximum anisotropy there: 32 / sqrt(4) texels.
TEST(Sample, ALineBeyondTheMaximalAnisotropyHasFewerTexels) {
    SampledTexture texture = leveledTexture(64);
    texture.maxAnisotropy = 4;
    const SampleRecord record = explainSample(texture, {0.5F, 0.5F, 0}, texelsPerPixel(texture, 2, 32),
                                              {.anisotropy = AnisotropyMethod::Line});
    EXPECT_FLOAT_EQ(record.lod.lambda, 4);
    EXPECT_EQ(record.lod.probes, 2) << "of 4 x 4 texels";
    EXPECT_FALSE(record.lod.alongX);
}

TEST(AnisotropyMethodOf, IsThatOfMesasVersion) {
    constexpr auto of = anisotropyMethodOf;
    EXPECT_EQ(of("llvmpipe (LLVM 15.0.6, 256 bits)", "4.5 (Compatibility Profile) Mesa 22.3.6"),
              AnisotropyMethod::Ellipse);
    EXPECT_EQ(of("llvmpipe (LLVM 19.1.7, 256 bits)", "4.5 (Compatibility Profile) Mesa 25.0.7-2+deb13u1"),
              AnisotropyMethod::Line);
    EXPECT_EQ(of("softpipe", "3.3 (Compatibility Profile) Mesa 25.0.7"), AnisotropyMethod::Ellipse);
    EXPECT_EQ(of("AMD Radeon", "4.6 Mesa 25.0.7"), AnisotropyMethod::Probes);
    EXPECT_EQ(of("", ""), AnisotropyMethod::Probes);
}

// Columns of 0 and 1, and more of them in a pixel than anyone could count: their mean.
TEST(Sample, AHugeEllipseAverages) {
    SampledTexture texture = leveledTexture(64);
    for (std::size_t i = 0; i < texture.levels[0].texels.size(); ++i)
        texture.levels[0].texels[i] = glm::vec4(static_cast<float>(i % 2));
    texture.maxAnisotropy = 16;
    texture.maxLod = 0;
    for (const float texels : {1e3F, 1e10F, 1e20F, 1e38F}) {
        const SampleRecord record =
            explainSample(texture, {0.5F, 0.5F, 0}, texelsPerPixel(texture, texels, texels / 2),
                          {.anisotropy = AnisotropyMethod::Ellipse});
        EXPECT_TRUE(record.lod.ellipse);
        EXPECT_TRUE(isNear(record.color, glm::vec4(0.5F), 0.01F)) << texels;
    }
}

// With L = 3e5: A = L^2 + 1, B = -2 L^2, C = L^2 + 2 and F = A C - B^2 / 4 = 3 L^2 + 2. Along the diagonal
// A + B + C = 3 is left of numbers that have eleven digits.
TEST(Ellipse, HoldsWhenItIsLongAndThin) {
    const Ellipse ellipse({3e5, 3e5}, {1, 0});
    EXPECT_NEAR(ellipse.radius2({30, 30}), 900 * 3 / 2.7e11, 1e-13);
    EXPECT_NEAR(ellipse.radius2({1, -1}), 4 * 9e10 / 2.7e11, 1e-9);
    EXPECT_NEAR(ellipse.halfExtent().x, 3e5, 1e-3);
}

struct Bad {
    const char* name;
    glm::vec3 coords;
    Derivatives derivatives;
};
class BadInput : public testing::TestWithParam<std::tuple<Bad, Wrap, Target, AnisotropyMethod>> {};

TEST_P(BadInput, GivesAColourBetweenThoseOfTheTexture) {
    const auto& [row, wrap, target, method] = GetParam();
    SampledTexture texture =
        indexTexture(target, {4, target == Target::Texture1D ? 1 : 4, target == Target::Texture3D ? 4 : 1});
    texture.wrapS = texture.wrapT = texture.wrapR = wrap;
    texture.maxAnisotropy = 16;
    const glm::vec4 color = sample(texture, row.coords, row.derivatives, {.anisotropy = method});
    for (int i = 0; i < 4; ++i) {
        EXPECT_GE(color[i], 0);
        EXPECT_LE(color[i], 1.0001F);
    }
}

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
INSTANTIATE_TEST_SUITE_P(
    All, BadInput,
    testing::Combine(
        testing::Values(Bad{"Nan", {nan, nan, nan}, {}}, Bad{"Infinite", {infinity, -infinity, infinity}, {}},
                        Bad{"Huge", {3e38F, -3e38F, 3e38F}, {{3e38F, 0, 0}, {0, 3e38F, 0}}},
                        Bad{"NanDerivative", {0.5F, 0.5F, 0.5F}, {{nan, 1, 0}, {0, 1, 0}}},
                        Bad{"HugeRatio", {0.5F, 0.5F, 0.5F}, {{1e18F, 0, 0}, {0, 1e-30F, 0}}},
                        Bad{"Far", {1e9F, -1e9F, 1e9F}, {{0.5F, 0, 0}, {0, 2, 0}}}),
        testing::Values(Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge, Wrap::ClampToBorder,
                        Wrap::Clamp),
        testing::Values(Target::Texture1D, Target::Texture2D, Target::Texture3D),
        testing::Values(AnisotropyMethod::Probes, AnisotropyMethod::Ellipse, AnisotropyMethod::Line)));

bool isBeyondLevel(const SampledTexture& texture, const Tap& tap) {
    const Level& level = texture.levels[static_cast<std::size_t>(tap.level)];
    return tap.index.x < 0 || tap.index.y < 0 || tap.index.x >= level.width || tap.index.y >= level.height;
}

// For every filter, wrap mode and footprint: what was recorded is what was sampled.
class Record
    : public testing::TestWithParam<std::tuple<MinFilter, MagFilter, Wrap, AnisotropyMethod, float>> {};

TEST_P(Record, AddsUpToTheColour) {
    const auto& [min, mag, wrap, method, anisotropy] = GetParam();
    SampledTexture texture;
    for (int n = 0, size = 16; size >= 1; ++n, size /= 2)
        texture.levels.push_back(makeLevel({size, size, 1}, [n](int i, int j, int) {
            return glm::vec4((i * 7 + n) % 5, (j * 3 + n) % 4, (i + j) % 3, 1 + (i ^ j) % 2) / 5.0F;
        }));
    texture.minFilter = min;
    texture.magFilter = mag;
    texture.wrapS = texture.wrapT = texture.wrapR = wrap;
    texture.borderColor = {1, 0.5F, 0.25F, 0.125F};
    texture.maxAnisotropy = anisotropy;
    for (const float texels : {0.4F, 1.3F, 3.7F, 20.0F}) {
        for (const glm::vec3 at :
             {glm::vec3(0.31F, 0.72F, 0), glm::vec3(-0.4F, 1.01F, 0), glm::vec3(5.9F, -3.3F, 0)}) {
            const Derivatives moving = texelsPerPixel(texture, texels, 1);
            const SampleRecord record = explainSample(texture, at, moving, {.anisotropy = method});
            EXPECT_EQ(record.color, sample(texture, at, moving, {.anisotropy = method}));
            glm::vec4 sum(0);
            float weight = 0;
            for (const Tap& tap : record.taps) {
                sum += tap.weight * tap.color;
                weight += tap.weight;
                EXPECT_EQ(tap.border, isBeyondLevel(texture, tap));
            }
            EXPECT_TRUE(isNear(sum, record.color));
            EXPECT_NEAR(weight, 1, 1e-5F);
            float levels = 0;
            for (const LevelShare& level : record.levels)
                levels += level.weight;
            EXPECT_NEAR(levels, 1, 1e-5F);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, Record,
    testing::Combine(testing::Values(MinFilter::Nearest, MinFilter::Linear, MinFilter::NearestMipmapNearest,
                                     MinFilter::LinearMipmapNearest, MinFilter::NearestMipmapLinear,
                                     MinFilter::LinearMipmapLinear),
                     testing::Values(MagFilter::Nearest, MagFilter::Linear),
                     testing::Values(Wrap::Repeat, Wrap::ClampToBorder, Wrap::Clamp),
                     testing::Values(AnisotropyMethod::Probes, AnisotropyMethod::Ellipse,
                                     AnisotropyMethod::Line),
                     testing::Values(1.0F, 8.0F)));

TEST(Sample, AnIncompleteTextureIsOpaqueBlack) {
    EXPECT_EQ(sample(SampledTexture{}, {0.5F, 0.5F, 0}, {}), glm::vec4(0, 0, 0, 1));
}

} // namespace
} // namespace texplorer::reference::sampler_test
