// Tables 3.21 and 3.22 of the OpenGL 2.1 specification, worked out by hand for
//
//   previous     Cp = (0.2, 0.4, 0.6)   Ap = 0.8
//   texture      Cs = (0.6, 0.2, 0.8)   As = 0.4   Ls = Is = its red, 0.6
//   environment  Cc = (0.4, 0.8, 0.2)   Ac = 0.6

#include "core/reference/shading/environment.h"
#include "core/reference/sampling/sampled_texture.h"
#include "tests/core/reference/textures.h"

#include <gmock/gmock.h>

#include <optional>

namespace texplorer::reference {
namespace {

using namespace testing_support;

constexpr glm::vec4 previous{0.2F, 0.4F, 0.6F, 0.8F};
constexpr glm::vec4 texel{0.6F, 0.2F, 0.8F, 0.4F};
constexpr glm::vec4 constant{0.4F, 0.8F, 0.2F, 0.6F};
constexpr std::optional<glm::vec4> undefinedResult{};

struct Case {
    const char* name;
    EnvMode mode;
    BaseFormat format;
    std::optional<glm::vec4> expected;
};

EnvironmentInputs inputs(BaseFormat format) {
    return {.previous = previous, .source = sourceColor(format, texel), .constant = constant};
}

class EnvironmentRule : public testing::TestWithParam<Case> {};

TEST_P(EnvironmentRule, GivesTheNumberOfTheTable) {
    const auto& [name, mode, format, expected] = GetParam();
    const EnvironmentResult found = evaluate(mode, format, inputs(format));
    EXPECT_EQ(found.undefined, !expected);
    EXPECT_TRUE(isNear(found.color, expected.value_or(previous)));
}

/// The number at the end of "0.2 * 0.6 = 0.12" or "0.6 + 0.8 = 1.4, clamped to 1".
float resultIn(const std::string& numbers) {
    return std::stof(numbers.substr(numbers.find_last_of(' ')));
}

TEST_P(EnvironmentRule, SaysTheSameInItsEquation) {
    const auto& [name, mode, format, expected] = GetParam();
    const EnvironmentEquations equations = equationsOf(mode, format, inputs(format));
    ASSERT_EQ(equations.color.numbers.size(), 3U);
    ASSERT_EQ(equations.alpha.numbers.size(), 1U);
    EXPECT_EQ(equations.undefined, !expected);
    const glm::vec4 said{resultIn(equations.color.numbers[0]), resultIn(equations.color.numbers[1]),
                         resultIn(equations.color.numbers[2]), resultIn(equations.alpha.numbers[0])};
    EXPECT_TRUE(isNear(said, expected.value_or(previous), 1e-4F));
}

using E = EnvMode;
using F = BaseFormat;

INSTANTIATE_TEST_SUITE_P(
    Tables, EnvironmentRule,
    testing::Values(
        Case{"ReplaceAlpha", E::Replace, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.4F}}},
        Case{"ReplaceLuminance", E::Replace, F::Luminance, {{0.6F, 0.6F, 0.6F, 0.8F}}},
        Case{"ReplaceLuminanceAlpha", E::Replace, F::LuminanceAlpha, {{0.6F, 0.6F, 0.6F, 0.4F}}},
        Case{"ReplaceIntensity", E::Replace, F::Intensity, {{0.6F, 0.6F, 0.6F, 0.6F}}},
        Case{"ReplaceRgb", E::Replace, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        Case{"ReplaceRgba", E::Replace, F::Rgba, {{0.6F, 0.2F, 0.8F, 0.4F}}},
        Case{"ModulateAlpha", E::Modulate, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"ModulateLuminance", E::Modulate, F::Luminance, {{0.12F, 0.24F, 0.36F, 0.8F}}},
        Case{"ModulateLuminanceAlpha", E::Modulate, F::LuminanceAlpha, {{0.12F, 0.24F, 0.36F, 0.32F}}},
        Case{"ModulateIntensity", E::Modulate, F::Intensity, {{0.12F, 0.24F, 0.36F, 0.48F}}},
        Case{"ModulateRgb", E::Modulate, F::Rgb, {{0.12F, 0.08F, 0.48F, 0.8F}}},
        Case{"ModulateRgba", E::Modulate, F::Rgba, {{0.12F, 0.08F, 0.48F, 0.32F}}},
        Case{"DecalAlpha", E::Decal, F::Alpha, undefinedResult},
        Case{"DecalLuminance", E::Decal, F::Luminance, undefinedResult},
        Case{"DecalLuminanceAlpha", E::Decal, F::LuminanceAlpha, undefinedResult},
        Case{"DecalIntensity", E::Decal, F::Intensity, undefinedResult},
        Case{"DecalRgb", E::Decal, F::Rgb, {{0.6F, 0.2F, 0.8F, 0.8F}}},
        Case{"DecalRgba", E::Decal, F::Rgba, {{0.36F, 0.32F, 0.68F, 0.8F}}},
        Case{"BlendAlpha", E::Blend, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"BlendLuminance", E::Blend, F::Luminance, {{0.32F, 0.64F, 0.36F, 0.8F}}},
        Case{"BlendLuminanceAlpha", E::Blend, F::LuminanceAlpha, {{0.32F, 0.64F, 0.36F, 0.32F}}},
        Case{"BlendIntensity", E::Blend, F::Intensity, {{0.32F, 0.64F, 0.36F, 0.68F}}},
        Case{"BlendRgb", E::Blend, F::Rgb, {{0.32F, 0.48F, 0.28F, 0.8F}}},
        Case{"BlendRgba", E::Blend, F::Rgba, {{0.32F, 0.48F, 0.28F, 0.32F}}},
        Case{"AddAlpha", E::Add, F::Alpha, {{0.2F, 0.4F, 0.6F, 0.32F}}},
        Case{"AddLuminance", E::Add, F::Luminance, {{0.8F, 1.0F, 1.0F, 0.8F}}},
        Case{"AddLuminanceAlpha", E::Add, F::LuminanceAlpha, {{0.8F, 1.0F, 1.0F, 0.32F}}},
        Case{"AddIntensity", E::Add, F::Intensity, {{0.8F, 1.0F, 1.0F, 1.0F}}},
        Case{"AddRgb", E::Add, F::Rgb, {{0.8F, 0.6F, 1.0F, 0.8F}}},
        Case{"AddRgba", E::Add, F::Rgba, {{0.8F, 0.6F, 1.0F, 0.32F}}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Equation, ReadsAsInTheSpecification) {
    const EnvironmentEquations decal = equationsOf(E::Decal, F::Rgba, inputs(F::Rgba));
    EXPECT_EQ(decal.color.symbols, "Cv = Cp * (1 - As) + Cs * As");
    EXPECT_THAT(decal.color.numbers, testing::ElementsAre("0.2 * (1 - 0.4) + 0.6 * 0.4 = 0.36",
                                                          "0.4 * (1 - 0.4) + 0.2 * 0.4 = 0.32",
                                                          "0.6 * (1 - 0.4) + 0.8 * 0.4 = 0.68"));
    EXPECT_THAT(decal.alpha.numbers, testing::ElementsAre("0.8 = 0.8"));
    const EnvironmentEquations blend = equationsOf(E::Blend, F::Intensity, inputs(F::Intensity));
    EXPECT_EQ(blend.alpha.symbols, "Av = Ap * (1 - As) + Ac * As");
    EXPECT_EQ(blend.alpha.numbers[0], "0.8 * (1 - 0.6) + 0.6 * 0.6 = 0.68");
    EXPECT_EQ(equationsOf(E::Add, F::Rgb, inputs(F::Rgb)).color.numbers[2], "0.6 + 0.8 = 1.4, clamped to 1");
    EXPECT_EQ(equationsOf(E::Decal, F::Alpha, inputs(F::Alpha)).color.symbols, "Cv = undefined; here Cp");
}

} // namespace
} // namespace texplorer::reference
