// Tables 3.23 to 3.25 of the OpenGL 2.1 specification, worked out by hand for
//
//   texture   (0.6, 0.2, 0.8, 0.4)    previous  (0.2, 0.4, 0.6, 0.8)
//   constant  (0.4, 0.8, 0.2, 0.5)    primary   (0.9, 0.1, 0.3, 0.7)    unit 2  (0.25, 0.5, 0.75, 1)

#include "tests/core/reference/textures.h"
#include "texplorer/reference/shading/combine.h"

namespace texplorer::reference::combine_test {
namespace {

using namespace test;

using Fn = CombineRgb;
using Src = CombineSource;
using Scale = CombineScale;

const EnvironmentInputs inputs{.previous = {0.2F, 0.4F, 0.6F, 0.8F},
                               .source = {0.6F, 0.2F, 0.8F, 0.4F},
                               .constant = {0.4F, 0.8F, 0.2F, 0.5F},
                               .primary = {0.9F, 0.1F, 0.3F, 0.7F}};
const glm::vec4 unit2{0.25F, 0.5F, 0.75F, 1};
const std::array<const glm::vec4*, 4> textures{&inputs.source, nullptr, &unit2, nullptr};

/// With the same function, sources and scale for the colour and for alpha.
Combine with(Fn function, std::array<Src, 3> sources = {Src::Texture, Src::Previous, Src::Constant},
             Scale scale = Scale::One) {
    Combine combine;
    combine.rgb = function;
    combine.alpha = static_cast<CombineAlpha>(function);
    combine.source0Rgb = combine.source0Alpha = sources[0];
    combine.source1Rgb = combine.source1Alpha = sources[1];
    combine.source2Rgb = combine.source2Alpha = sources[2];
    combine.operand2Rgb = OperandRgb::SrcColor;
    combine.rgbScale = combine.alphaScale = scale;
    return combine;
}

Combine withOperand(OperandRgb color, OperandAlpha alpha) {
    Combine combine = with(Fn::Replace);
    combine.operand0Rgb = color;
    combine.operand0Alpha = alpha;
    return combine;
}

Combine dot(Fn function, Scale scale = Scale::One) {
    Combine combine;
    combine.rgb = function;
    combine.rgbScale = scale;
    combine.alpha = CombineAlpha::Replace;
    combine.source0Alpha = Src::Constant;
    return combine;
}

struct Case {
    const char* name;
    Combine combine;
    glm::vec4 expected;
    bool undefined = false;
};
class CombineRule : public testing::TestWithParam<Case> {};

TEST_P(CombineRule, GivesTheNumberOfTheTable) {
    const EnvironmentResult found = evaluate(GetParam().combine, inputs, textures);
    EXPECT_EQ(found.undefined, GetParam().undefined);
    EXPECT_TRUE(isNear(found.color, GetParam().expected));
}

/// The number at the end of "0.2 * 0.6 = 0.12" or "0.6 + 0.8 = 1.4, clamped to 1".
float resultIn(const std::string& numbers) {
    return std::stof(numbers.substr(numbers.find_last_of(' ')));
}

TEST_P(CombineRule, SaysTheSameInItsEquation) {
    const auto& [name, combine, expected, undefined] = GetParam();
    const EnvironmentEquations equations = equationsOf(combine, inputs, textures);
    ASSERT_EQ(equations.color.numbers.size(), 3U);
    ASSERT_EQ(equations.alpha.numbers.size(), 1U);
    EXPECT_EQ(equations.undefined, undefined);
    const glm::vec4 said{resultIn(equations.color.numbers[0]), resultIn(equations.color.numbers[1]),
                         resultIn(equations.color.numbers[2]), resultIn(equations.alpha.numbers[0])};
    EXPECT_TRUE(isNear(said, expected, 1e-4F));
}

struct Written {
    const char* name;
    Combine combine;
    const char* symbols;
    const char* red;
    const char* alphaSymbols;
    const char* alpha;
};
class CombineText : public testing::TestWithParam<Written> {};

TEST_P(CombineText, NamesItsSources) {
    const auto& [name, combine, symbols, red, alphaSymbols, alpha] = GetParam();
    const EnvironmentEquations equations = equationsOf(combine, inputs, textures);
    EXPECT_EQ(equations.color.symbols, symbols);
    EXPECT_EQ(equations.color.numbers.at(0), red);
    EXPECT_EQ(equations.alpha.symbols, alphaSymbols);
    EXPECT_EQ(equations.alpha.numbers.at(0), alpha);
}

INSTANTIATE_TEST_SUITE_P(
    All, CombineText,
    testing::Values(
        Written{"Initial", {}, "Cv = Cs * Cp", "0.6 * 0.2 = 0.12", "Av = As * Ap", "0.4 * 0.8 = 0.32"},
        Written{"Interpolate", with(Fn::Interpolate), "Cv = Cs * Cc + Cp * (1 - Cc)",
                "0.6 * 0.4 + 0.2 * (1 - 0.4) = 0.36", "Av = As * Ac + Ap * (1 - Ac)",
                "0.4 * 0.5 + 0.8 * (1 - 0.5) = 0.6"},
        Written{"CrossbarScaled", with(Fn::Add, {Src::Texture2, Src::PrimaryColor, Src::Texture}, Scale::Two),
                "Cv = 2 * (Cs2 + Cf)", "2 * (0.25 + 0.9) = 2.3, clamped to 1", "Av = 2 * (As2 + Af)",
                "2 * (1 + 0.7) = 3.4, clamped to 1"},
        Written{"Operands", withOperand(OperandRgb::OneMinusSrcAlpha, OperandAlpha::OneMinusSrcAlpha),
                "Cv = (1 - As)", "(1 - 0.4) = 0.6", "Av = (1 - As)", "(1 - 0.4) = 0.6"},
        Written{"Signed", with(Fn::AddSigned), "Cv = Cs + Cp - 0.5", "0.6 + 0.2 - 0.5 = 0.3",
                "Av = As + Ap - 0.5", "0.4 + 0.8 - 0.5 = 0.7"},
        Written{"Dot", dot(Fn::Dot3Rgb), "Cv = 4 * (Cs - 0.5) · (Cp - 0.5)",
                "4 * ((0.6 - 0.5) * (0.2 - 0.5) + (0.2 - 0.5) * (0.4 - 0.5) + (0.8 - 0.5) * (0.6 - 0.5)) = "
                "0.12",
                "Av = Ac", "0.5 = 0.5"},
        Written{"Undefined", with(Fn::Replace, {Src::Texture1, Src::Texture, Src::Texture}),
                "Cv = undefined; here Cp", "0.2 = 0.2", "Av = undefined; here Ap", "0.8 = 0.8"}),
    [](const auto& test) { return std::string(test.param.name); });

INSTANTIATE_TEST_SUITE_P(
    All, CombineRule,
    testing::Values(
        Case{"Initial", {}, {0.12F, 0.08F, 0.48F, 0.32F}}, Case{"Replace", with(Fn::Replace), inputs.source},
        Case{"Modulate", with(Fn::Modulate), {0.12F, 0.08F, 0.48F, 0.32F}},
        Case{"Add", with(Fn::Add), {0.8F, 0.6F, 1, 1}},
        Case{"AddSigned", with(Fn::AddSigned), {0.3F, 0.1F, 0.9F, 0.7F}},
        // first * third + second * (1 - third)
        Case{"Interpolate", with(Fn::Interpolate), {0.36F, 0.24F, 0.64F, 0.6F}},
        Case{"Subtract", with(Fn::Subtract), {0.4F, 0, 0.2F, 0}},
        // 4 (0.1 * -0.3 + -0.3 * -0.1 + 0.3 * 0.1) = 0.12
        Case{"Dot3Rgb", dot(Fn::Dot3Rgb), {0.12F, 0.12F, 0.12F, 0.5F}},
        // ARB_texture_env_dot3 multiplies by both scales: alpha has its own
        Case{"Dot3Rgba", dot(Fn::Dot3Rgba, Scale::Four), {0.48F, 0.48F, 0.48F, 0.12F}},
        Case{"OneMinusColor",
             withOperand(OperandRgb::OneMinusSrcColor, OperandAlpha::OneMinusSrcAlpha),
             {0.4F, 0.8F, 0.2F, 0.6F}},
        Case{"Alpha", withOperand(OperandRgb::SrcAlpha, OperandAlpha::SrcAlpha), {0.4F, 0.4F, 0.4F, 0.4F}},
        Case{"OneMinusAlpha",
             withOperand(OperandRgb::OneMinusSrcAlpha, OperandAlpha::SrcAlpha),
             {0.6F, 0.6F, 0.6F, 0.4F}},
        Case{"Primary", with(Fn::Replace, {Src::PrimaryColor, Src::Texture, Src::Texture}), inputs.primary},
        Case{"Constant", with(Fn::Replace, {Src::Constant, Src::Texture, Src::Texture}), inputs.constant},
        Case{"Crossbar", with(Fn::Replace, {Src::Texture2, Src::Texture, Src::Texture}), unit2},
        Case{"Scale2",
             with(Fn::Replace, {Src::Texture, Src::Texture, Src::Texture}, Scale::Two),
             {1, 0.4F, 1, 0.8F}},
        Case{"Scale4",
             with(Fn::Subtract, {Src::Texture, Src::Previous, Src::Texture}, Scale::Four),
             {1, 0, 0.8F, 0}},
        Case{"UnitThatIsOff", with(Fn::Replace, {Src::Texture1, Src::Texture, Src::Texture}), inputs.previous,
             true},
        Case{"UnitThatIsOffButNotRead", with(Fn::Replace, {Src::Texture, Src::Texture1, Src::Texture}),
             inputs.source}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::reference::combine_test
