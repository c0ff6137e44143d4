// The reference's environment against the specification's tables, and the equations that it shows.

#include "core/reference/sampling/sampled_texture.h"
#include "core/reference/shading/environment.h"
#include "tests/core/reference/textures.h"
#include "tests/support/environment_cases.h"

#include <gmock/gmock.h>

namespace texplorer::reference::environment_test {
namespace {

using namespace test;
using texplorer::test::EnvironmentCase;
using texplorer::test::environmentCases;

constexpr glm::vec4 previous = EnvironmentCase::fragment;

EnvironmentInputs inputs(BaseFormat format) {
    return {.previous = previous,
            .source = sourceColor(format, EnvironmentCase::texel),
            .constant = EnvironmentCase::environment};
}

class EnvironmentRule : public testing::TestWithParam<EnvironmentCase> {};

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

INSTANTIATE_TEST_SUITE_P(Tables, EnvironmentRule, testing::ValuesIn(environmentCases),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Equation, ReadsAsInTheSpecification) {
    using E = EnvMode;
    using F = BaseFormat;
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
} // namespace texplorer::reference::environment_test
