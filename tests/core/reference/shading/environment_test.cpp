// The reference's environment against the specification's tables, and the equations that it shows.

#include "tests/core/reference/textures.h"
#include "tests/support/environment_cases.h"
#include "texplorer/reference/sampling/sampled_texture.h"
#include "texplorer/reference/shading/environment.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <random>
#include <string>
#include <string_view>
#include <utility>

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

/// What a reader works out who takes an equation at its word: + and -, before them *, and parentheses.
class Reader {
public:
    Reader(std::string_view text, std::map<std::string, float> values)
        : text_(text)
        , values_(std::move(values)) {}

    float sum() {
        float result = product();
        for (;;) {
            if (take('+'))
                result += product();
            else if (take('-'))
                result -= product();
            else
                return result;
        }
    }

private:
    float product() {
        float result = factor();
        while (take('*'))
            result *= factor();
        return result;
    }
    float factor() {
        if (take('(')) {
            const float result = sum();
            EXPECT_TRUE(take(')')) << text_;
            return result;
        }
        std::string word;
        while (!text_.empty() && std::isalnum(static_cast<unsigned char>(text_.front())) != 0) {
            word += text_.front();
            text_.remove_prefix(1);
        }
        if (word == "1")
            return 1;
        EXPECT_TRUE(values_.contains(word)) << word;
        return values_[word];
    }
    bool take(char sign) {
        while (text_.starts_with(' '))
            text_.remove_prefix(1);
        if (!text_.starts_with(sign))
            return false;
        text_.remove_prefix(1);
        while (text_.starts_with(' '))
            text_.remove_prefix(1);
        return true;
    }

    std::string_view text_;
    std::map<std::string, float> values_;
};

TEST(Equation, IsWhatIsComputedWhateverTheColours) {
    std::mt19937 dice(1);
    std::uniform_real_distribution<float> any(0, 1);
    const auto color = [&] { return glm::vec4(any(dice), any(dice), any(dice), any(dice)); };
    for (const EnumRow& mode : envModeRows) {
        for (const EnumRow& base : baseFormatRows) {
            const auto format = static_cast<BaseFormat>(base.value);
            for (int i = 0; i < 20; ++i) {
                const EnvironmentInputs in{color(), sourceColor(format, color()), color(), color()};
                const auto envMode = static_cast<EnvMode>(mode.value);
                const EnvironmentEquations said = equationsOf(envMode, format, in);
                const EnvironmentResult made = evaluate(envMode, format, in);
                ASSERT_EQ(said.undefined, made.undefined);
                if (said.undefined)
                    continue;
                for (int c = 0; c < 4; ++c) {
                    const std::string& symbols = c < 3 ? said.color.symbols : said.alpha.symbols;
                    Reader reader(std::string_view(symbols).substr(std::string_view("Cv = ").size()),
                                  {{"Cp", in.previous[c]},
                                   {"Cs", in.source[c]},
                                   {"Cc", in.constant[c]},
                                   {"Ap", in.previous.a},
                                   {"As", in.source.a},
                                   {"Ac", in.constant.a}});
                    EXPECT_NEAR(std::clamp(reader.sum(), 0.0F, 1.0F), made.color[c], 1e-6F)
                        << mode.name << ' ' << base.name << ": " << symbols;
                }
            }
        }
    }
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
