#include "tests/core/reference/textures.h"
#include "tests/support/environment_cases.h"
#include "texplorer/reference/shading/environment_table.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

namespace texplorer::reference::environment_table_test {
namespace {

using texplorer::test::EnvironmentCase;
using texplorer::test::environmentCases;

constexpr TableColors handColors{EnvironmentCase::fragment, EnvironmentCase::texel,
                                 EnvironmentCase::environment};

/// One texel of the colour that the hand-worked table has: 0.6 is 153 of 255, and so on, without a remainder.
Image oneTexel() {
    Image image = Image::uninitialised(PixelFormat::Rgba8, 1, 1);
    for (std::size_t i = 0; i < 4; ++i)
        image.pixels[i] = static_cast<std::byte>(
            static_cast<int>(std::lround(EnvironmentCase::texel[static_cast<int>(i)] * 255)));
    return image;
}

std::array<int, 4> bytesAt(const Image& image, int x, int y) {
    std::array<int, 4> bytes{};
    for (std::size_t i = 0; i < 4; ++i)
        bytes.at(i) = std::to_integer<int>(image.at(x, y)[i]);
    return bytes;
}

std::array<int, 4> bytesOf(glm::vec4 color) {
    std::array<int, 4> bytes{};
    for (int i = 0; i < 4; ++i)
        bytes.at(static_cast<std::size_t>(i)) = static_cast<int>(std::lround(color[i] * 255));
    return bytes;
}

class EnvironmentTable : public testing::TestWithParam<EnvironmentCase> {};

TEST_P(EnvironmentTable, HasTheNumberOfTheSpecificationInItsCell) {
    const auto& [name, mode, format, expected] = GetParam();
    const Image all = environmentPictures(oneTexel(), handColors);
    ASSERT_EQ(all.width, 5);
    ASSERT_EQ(all.height, 6);
    const auto column = static_cast<int>(std::ranges::find(tableModes, mode) - tableModes.begin());
    const auto row = static_cast<int>(std::ranges::find(tableFormats, format) - tableFormats.begin());
    const std::array<int, 4> wanted = expected ? bytesOf(*expected) : std::array{0, 0, 0, 0};
    EXPECT_EQ(bytesAt(all, column, 5 - row), wanted);
}

INSTANTIATE_TEST_SUITE_P(Table, EnvironmentTable, testing::ValuesIn(environmentCases),
                         [](const auto& tested) { return tested.param.name; });

using Printed = std::pair<std::string, std::string>;

TEST(EnvironmentEquation, IsPrintedAsInATextbook) {
    const auto printed = [](EnvMode mode, BaseFormat format) {
        const EnvironmentEquations equations = equationsOf(mode, format, {});
        return Printed(printedEquation(equations.color.symbols), printedEquation(equations.alpha.symbols));
    };
    EXPECT_EQ(printed(EnvMode::Replace, BaseFormat::Alpha), Printed("Cp", "As"));
    EXPECT_EQ(printed(EnvMode::Modulate, BaseFormat::Rgba), Printed("Cp Cs", "Ap As"));
    EXPECT_EQ(printed(EnvMode::Decal, BaseFormat::Rgba), Printed("Cp (1 − As) + Cs As", "Ap"));
    EXPECT_EQ(printed(EnvMode::Blend, BaseFormat::Intensity),
              Printed("Cp (1 − Cs) + Cc Cs", "Ap (1 − As) + Ac As"));
    EXPECT_EQ(printed(EnvMode::Add, BaseFormat::Rgb), Printed("Cp + Cs", "Ap"));
}

TEST(SourceSymbols, AreWhatTheFormatMakesOfTheTexel) {
    // Lt and It are the texel's red (table 3.15).
    const std::map<std::string_view, glm::vec4> values{{"0", glm::vec4(0)},
                                                       {"1", glm::vec4(1)},
                                                       {"Ct", EnvironmentCase::texel},
                                                       {"At", glm::vec4(EnvironmentCase::texel.a)},
                                                       {"Lt", glm::vec4(EnvironmentCase::texel.r)},
                                                       {"It", glm::vec4(EnvironmentCase::texel.r)}};
    for (const BaseFormat format : tableFormats) {
        const auto [color, alpha] = sourceSymbols(format);
        const glm::vec4 source = inputsOf(format, handColors).source;
        EXPECT_EQ(glm::vec3(source), glm::vec3(values.at(color))) << color;
        EXPECT_EQ(source.a, values.at(alpha).a) << alpha;
    }
}

TEST(HueAndAlpha, TheGradientHasEveryHueAndEveryAlpha) {
    const Image gradient = hueAndAlpha(13);
    EXPECT_EQ(bytesAt(gradient, 0, 0), (std::array{255, 0, 0, 0}));
    EXPECT_EQ(bytesAt(gradient, 4, 12), (std::array{0, 255, 0, 255}));
    EXPECT_EQ(bytesAt(gradient, 8, 12), (std::array{0, 0, 255, 255}));
    EXPECT_EQ(bytesAt(gradient, 12, 6), (std::array{255, 0, 0, 128}));
}

} // namespace
} // namespace texplorer::reference::environment_table_test
