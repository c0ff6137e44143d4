// Depth textures: OpenGL 2.1, section 3.8.14, worked out by hand.

#include "tests/core/reference/textures.h"
#include "texplorer/reference/raster/kernel.h"
#include "texplorer/reference/sampling/depth_texel.h"
#include "texplorer/reference/sampling/sampler.h"

#include <gtest/gtest.h>

#include <limits>

namespace texplorer::reference::depth_texel_test {
namespace {

using namespace test;

/// Depths of 0, 0.25, 0.5 and 1 in a row; beyond it 0.75.
SampledTexture depths(const SamplerState& state = {}) {
    constexpr std::array<float, 4> row{0, 0.25F, 0.5F, 1};
    SampledTexture texture;
    texture.internalFormat = InternalFormat::DepthComponent24;
    texture.levels = {makeLevel({4, 1, 1}, [&](int i, int, int) {
        return glm::vec4(glm::vec3(row.at(static_cast<std::size_t>(i))), 1);
    })};
    SamplerState given = state;
    given.minFilter = given.magFilter == MagFilter::Linear ? MinFilter::Linear : MinFilter::Nearest;
    given.wrapS = given.wrapT = Wrap::ClampToBorder;
    given.borderColor = {0.75F, 0.1F, 0.2F, 0.3F};
    setParameters(texture, given, 1000);
    return texture;
}

/// At the centre of a texel.
float at(int texel) {
    return (static_cast<float>(texel) + 0.5F) / 4;
}

struct FunctionCase {
    CompareFunc function;
    std::array<int, 4> passes; ///< r = 0.25 against 0, 0.25, 0.5 and 1
};

TEST(DepthTexture, ComparesRWithTheDepth) {
    for (const auto& [function, passes] :
         {FunctionCase{CompareFunc::Never, {0, 0, 0, 0}}, FunctionCase{CompareFunc::Less, {0, 0, 1, 1}},
          FunctionCase{CompareFunc::Equal, {0, 1, 0, 0}}, FunctionCase{CompareFunc::LessEqual, {0, 1, 1, 1}},
          FunctionCase{CompareFunc::Greater, {1, 0, 0, 0}}, FunctionCase{CompareFunc::NotEqual, {1, 0, 1, 1}},
          FunctionCase{CompareFunc::GreaterEqual, {1, 1, 0, 0}},
          FunctionCase{CompareFunc::Always, {1, 1, 1, 1}}}) {
        const SampledTexture texture = depths({.magFilter = MagFilter::Nearest,
                                               .compareMode = CompareMode::RToTexture,
                                               .compareFunc = function});
        for (int i = 0; i < 4; ++i)
            EXPECT_TRUE(
                isNear(sample(texture, {at(i), 0.5F, 0.25F}, {}),
                       glm::vec4(glm::vec3(static_cast<float>(passes.at(static_cast<std::size_t>(i)))), 1)))
                << rowOf(function).name << " " << i;
    }
}

TEST(DepthTexture, ClampsRToThoseThatCanBeStored) {
    const auto passes = [](CompareFunc function, int texel, float r) {
        return sample(depths({.magFilter = MagFilter::Nearest,
                              .compareMode = CompareMode::RToTexture,
                              .compareFunc = function}),
                      {at(texel), 0.5F, r}, {})
                   .r == 1;
    };
    EXPECT_TRUE(passes(CompareFunc::LessEqual, 3, 7)) << "1 against 1";
    EXPECT_FALSE(passes(CompareFunc::Less, 3, 7));
    EXPECT_TRUE(passes(CompareFunc::Equal, 0, -3)) << "0 against 0";
    EXPECT_TRUE(passes(CompareFunc::Equal, 3, std::numeric_limits<float>::infinity()));
    EXPECT_TRUE(passes(CompareFunc::Equal, 0, std::numeric_limits<float>::quiet_NaN()));
}

// u = 2: half of texel 1 and half of texel 2. r = 0.4 passes against 0.5 alone; against their mean, 0.375,
// it would not.
TEST(DepthTexture, FiltersWhatComesOfComparing) {
    const SampledTexture texture =
        depths({.compareMode = CompareMode::RToTexture, .compareFunc = CompareFunc::LessEqual});
    EXPECT_TRUE(isNear(sample(texture, {0.5F, 0.5F, 0.4F}, {}), {0.5F, 0.5F, 0.5F, 1}));
    EXPECT_TRUE(isNear(sample(texture, {1.75F / 4, 0.5F, 0.4F}, {}), {0.25F, 0.25F, 0.25F, 1}));
}

TEST(DepthTexture, GivesTheDepthItselfWhereNothingIsCompared) {
    EXPECT_TRUE(isNear(sample(depths(), {0.5F, 0.5F, 9}, {}), {0.375F, 0.375F, 0.375F, 1}));
}

TEST(DepthTexture, BecomesLuminanceIntensityOrAlpha) {
    for (const auto& [mode, color, format] :
         {std::tuple{DepthMode::Luminance, glm::vec4(0.25F, 0.25F, 0.25F, 1), BaseFormat::Luminance},
          std::tuple{DepthMode::Intensity, glm::vec4(0.25F), BaseFormat::Intensity},
          std::tuple{DepthMode::Alpha, glm::vec4(0, 0, 0, 0.25F), BaseFormat::Alpha}}) {
        const SampledTexture texture = depths({.magFilter = MagFilter::Nearest, .depthMode = mode});
        EXPECT_EQ(texture.format, format) << "which the environment asks for";
        EXPECT_TRUE(isNear(sample(texture, {at(1), 0.5F, 0}, {}), color));
    }
}

TEST(DepthTexture, ComparesWithTheRedOfTheBorderColour) {
    const auto result = [](float r) {
        return sample(depths({.magFilter = MagFilter::Nearest, .compareMode = CompareMode::RToTexture}),
                      {2, 0.5F, r}, {})
            .r;
    };
    EXPECT_EQ(result(0.74F), 1);
    EXPECT_EQ(result(0.76F), 0);
}

TEST(DepthTexture, IsExplainedByTheDepthsThatWereRead) {
    const SampleRecord record =
        explainSample(depths({.compareMode = CompareMode::RToTexture}), {0.5F, 0.5F, 0.4F}, {});
    float passed = 0;
    bool found = false;
    for (const Tap& tap : record.taps) {
        passed += tap.weight * tap.color.r;
        found = found || (tap.index.x == 2 && tap.depth == 0.5F && tap.color.r == 1);
    }
    EXPECT_TRUE(found);
    EXPECT_NEAR(passed, record.color.r, 1e-6F);
}

TEST(DepthTexture, ComparesThePixelsOwnRWhateverTheFootprint) {
    SampledTexture texture = depths({.compareMode = CompareMode::RToTexture});
    texture.maxAnisotropy = 8;
    const Derivatives steep{{0.5F, 0, 10}, {0, 0.01F, 0}};
    for (const AnisotropyMethod method :
         {AnisotropyMethod::Probes, AnisotropyMethod::Ellipse, AnisotropyMethod::Line}) {
        const SampleOptions options{.anisotropy = method};
        EXPECT_TRUE(isNear(sample(texture, {0.5F, 0.5F, 0}, steep, options), {1, 1, 1, 1}))
            << "nothing is nearer";
    }
}

TEST(DepthTexture, IsSampledAlikeByEveryKernel) {
    for (const CompareMode mode : {CompareMode::None, CompareMode::RToTexture}) {
        const SampledTexture texture = depths({.compareMode = mode});
        const FastSampler sampler(texture, {});
        EXPECT_TRUE(sampler.readsR);
        SampleRow row{};
        for (std::size_t i = 0; i < row.s.size(); ++i) {
            row.s[i] = static_cast<float>(i) / 20 - 0.2F;
            row.t[i] = 0.4F;
            row.r[i] = static_cast<float>(i % 7) / 5 - 0.1F;
        }
        for (const Kernel* kernel : kernels()) {
            std::array<glm::vec4, SampleRow::capacity> colors{};
            kernel->sample(sampler, row, SampleRow::capacity, colors.data());
            for (std::size_t i = 0; i < colors.size(); ++i)
                EXPECT_EQ(colors[i], sample(texture, {row.s[i], row.t[i], row.r[i]}, {})) << i;
        }
    }
}

} // namespace
} // namespace texplorer::reference::depth_texel_test
