// The texture environment against tables 3.21 and 3.22 of the OpenGL 2.1 specification, worked out by hand
// for
//
//   fragment     Cf = (0.2, 0.4, 0.6)   Af = 0.8
//   texel        Ct = (0.6, 0.2, 0.8)   At = 0.4   Lt = It = its red, 0.6 (table 3.15)
//   environment  Cc = (0.4, 0.8, 0.2)   Ac = 0.6

#include "tests/support/flat_scene.h"
#include "tests/support/render_fixture.h"

#include <gmock/gmock.h>

#include <optional>

namespace texplorer {
namespace {

using namespace testing_support;

constexpr glm::vec4 fragment{0.2F, 0.4F, 0.6F, 0.8F};
constexpr Texel texel{153, 51, 204, 102};
constexpr glm::vec4 environment{0.4F, 0.8F, 0.2F, 0.6F};

constexpr std::optional<glm::vec4> undefinedResult{};

struct Case {
    const char* name;
    EnvMode mode;
    BaseFormat format;
    std::optional<glm::vec4> expected;
};

class Environment : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(Environment, GivesTheNumberOfTheTable) {
    images.put("image", plainImage(1, 1, texel));
    Scene scene = texturedScene();
    scene.material.color = fragment;
    scene.textures[0].internalFormat = GetParam().format;
    scene.passes[0].units[0].envMode = GetParam().mode;
    scene.passes[0].units[0].envColor = environment;
    const glm::vec4 found = onlyColor(scene);
    EXPECT_THAT(problems, testing::IsEmpty());
    if (GetParam().expected) {
        EXPECT_TRUE(isColor(found, *GetParam().expected));
    }
}

using E = EnvMode;
using F = BaseFormat;

INSTANTIATE_TEST_SUITE_P(
    Tables, Environment,
    testing::Values(
        // C = Cf or Ct, A = Af or At: whatever the texture has replaces the fragment's
        Case{"ReplaceAlpha", E::Replace, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.4F}}},
        Case{"ReplaceLuminance", E::Replace, F::Luminance, {{0.6F, 0.6F, 0.6F, 0.8F}}},
        Case{"ReplaceLuminanceAlpha", E::Replace, F::LuminanceAlpha, {{0.6F, 0.6F, 0.6F, 0.4F}}},
        Case{"ReplaceIntensity", E::Replace, F::Intensity, {{0.6F, 0.6F, 0.6F, 0.6F}}},
        Case{"ReplaceRgb", E::Replace, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        Case{"ReplaceRgba", E::Replace, F::Rgba, {{0.6F, 0.2F, 0.8F, 0.4F}}},
        // C = Cf Ct, A = Af At
        Case{"ModulateAlpha", E::Modulate, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"ModulateLuminance", E::Modulate, F::Luminance, {{0.12F, 0.24F, 0.36F, 0.8F}}},
        Case{"ModulateLuminanceAlpha", E::Modulate, F::LuminanceAlpha, {{0.12F, 0.24F, 0.36F, 0.32F}}},
        Case{"ModulateIntensity", E::Modulate, F::Intensity, {{0.12F, 0.24F, 0.36F, 0.48F}}},
        Case{"ModulateRgb", E::Modulate, F::Rgb, {{0.12F, 0.08F, 0.48F, 0.8F}}},
        Case{"ModulateRgba", E::Modulate, F::Rgba, {{0.12F, 0.08F, 0.48F, 0.32F}}},
        // C = Cf (1 - At) + Ct At, A = Af; the other formats are undefined
        Case{"DecalAlpha", E::Decal, F::Alpha, undefinedResult},
        Case{"DecalLuminance", E::Decal, F::Luminance, undefinedResult},
        Case{"DecalLuminanceAlpha", E::Decal, F::LuminanceAlpha, undefinedResult},
        Case{"DecalIntensity", E::Decal, F::Intensity, undefinedResult},
        Case{"DecalRgb", E::Decal, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        Case{"DecalRgba", E::Decal, F::Rgba, {{0.36F, 0.32F, 0.68F, 0.8F}}},
        // C = Cf (1 - Ct) + Cc Ct, A = Af At; INTENSITY blends alpha too: Af (1 - It) + Ac It
        Case{"BlendAlpha", E::Blend, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"BlendLuminance", E::Blend, F::Luminance, {{0.32F, 0.64F, 0.36F, 0.8F}}},
        Case{"BlendLuminanceAlpha", E::Blend, F::LuminanceAlpha, {{0.32F, 0.64F, 0.36F, 0.32F}}},
        Case{"BlendIntensity", E::Blend, F::Intensity, {{0.32F, 0.64F, 0.36F, 0.68F}}},
        Case{"BlendRgb", E::Blend, F::Rgb, {{0.32F, 0.48F, 0.28F, 0.8F}}},
        Case{"BlendRgba", E::Blend, F::Rgba, {{0.32F, 0.48F, 0.28F, 0.32F}}},
        // C = Cf + Ct, A = Af At; INTENSITY adds alpha too; sums end at 1
        Case{"AddAlpha", E::Add, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"AddLuminance", E::Add, F::Luminance, {{0.8F, 1.0F, 1.0F, 0.8F}}},
        Case{"AddLuminanceAlpha", E::Add, F::LuminanceAlpha, {{0.8F, 1.0F, 1.0F, 0.32F}}},
        Case{"AddIntensity", E::Add, F::Intensity, {{0.8F, 1.0F, 1.0F, 1.0F}}},
        Case{"AddRgb", E::Add, F::Rgb, {{0.8F, 0.6F, 1.0F, 0.8F}}},
        Case{"AddRgba", E::Add, F::Rgba, {{0.8F, 0.6F, 1.0F, 0.32F}}}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer
