#include "app/ui/widgets/palette.h"
#include "app/ui/widgets/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace texplorer::palette_test {
namespace {

using namespace ui;

using Rgb = std::array<double, 3>;
using Matrix = std::array<Rgb, 3>;

Rgb unpack(ImU32 color) {
    return {(color & 255U) / 255.0, (color >> 8 & 255U) / 255.0, (color >> 16 & 255U) / 255.0};
}

/// The visible colour over an opaque one.
Rgb over(ImU32 color, Rgb ground) {
    const double alpha = (color >> 24) / 255.0;
    Rgb seen = unpack(color);
    for (std::size_t i = 0; i < 3; ++i)
        seen[i] = alpha * seen[i] + (1 - alpha) * ground[i];
    return seen;
}

double linear(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// WCAG 2.1, "relative luminance" and "contrast ratio".
double luminance(Rgb color) {
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}
double contrast(Rgb a, Rgb b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)}); // by value
    return (light + 0.05) / (dark + 0.05);
}

TEST(Contrast, IsThatOfTheSpecification) {
    EXPECT_NEAR(contrast({0, 0, 0}, {1, 1, 1}), 21, 1e-9);
    EXPECT_NEAR(contrast(unpack(IM_COL32(119, 119, 119, 255)), {1, 1, 1}), 4.48, 0.005); // #777 just fails
}

/// Machado, Oliveira, Fernandes: A Physiologically-based Model for Simulation of Color Vision Deficiency,
/// IEEE TVCG 15 (2009), table 1, severity 1.0; on linear RGB.
struct Vision {
    const char* name;
    Matrix matrix;
};
constexpr std::array visions{
    Vision{"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    Vision{"protanopia",
           {{{0.152286, 1.052583, -0.204868},
             {0.114503, 0.786281, 0.099216},
             {-0.003882, -0.048116, 1.051998}}}},
    Vision{
        "deuteranopia",
        {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    Vision{"tritanopia",
           {{{1.255528, -0.076749, -0.178779},
             {-0.078411, 0.930809, 0.147602},
             {0.004733, 0.691367, 0.303900}}}},
};

/// CIE 1976 L*a*b* of the perceived colour, for the white of sRGB (D65).
Rgb labOf(ImU32 color, const Matrix& vision) {
    Rgb given = unpack(color);
    std::ranges::transform(given, given.begin(), linear);
    Rgb seen{};
    for (std::size_t i = 0; i < 3; ++i)
        seen[i] =
            std::clamp(vision[i][0] * given[0] + vision[i][1] * given[1] + vision[i][2] * given[2], 0.0, 1.0);
    const auto [r, g, b] = seen;
    const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double distance(Rgb a, Rgb b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

struct Named {
    const char* name;
    ImU32 Palette::*color;
};

constexpr std::array marks{
    Named{"s", &Palette::s},
    Named{"t", &Palette::t},
    Named{"r", &Palette::r},
    Named{"q", &Palette::q},
    Named{"chosen", &Palette::chosen},
    Named{"probed", &Palette::probed},
    Named{"changed", &Palette::changed},
    Named{"problem", &Palette::problem},
};

class Themes : public testing::TestWithParam<ThemeRow> {
protected:
    Themes() {
        ImGui::CreateContext();
        applyTheme(1, {GetParam().theme});
    }
    ~Themes() override {
        applyTheme(1);
        ImGui::DestroyContext();
    }
    Themes(const Themes&) = delete;
    Themes& operator=(const Themes&) = delete;

    /// A ground as it appears over the panel.
    [[nodiscard]] static Rgb ground(ImGuiCol style) {
        return over(ImGui::ColorConvertFloat4ToU32(ImGui::GetStyleColorVec4(style)), unpack(palette().panel));
    }
};

INSTANTIATE_TEST_SUITE_P(Each, Themes, testing::ValuesIn(themeRows), [](const auto& theme) {
    std::string name(theme.param.name);
    std::erase(name, '-');
    return name;
});

constexpr double forText = 4.5;  // WCAG 2.1, 1.4.3, level AA
constexpr double forMarks = 3.0; // 1.4.11

TEST_P(Themes, TextCanBeReadOnEveryGround) {
    for (const ImGuiCol style :
         {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_TitleBgActive, ImGuiCol_FrameBg,
          ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_Button, ImGuiCol_ButtonHovered,
          ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive, ImGuiCol_Tab,
          ImGuiCol_TabHovered, ImGuiCol_TabActive, ImGuiCol_TableHeaderBg, ImGuiCol_TextSelectedBg})
        EXPECT_GE(contrast(unpack(color::text), ground(style)), forText) << ImGui::GetStyleColorName(style);
}

TEST_P(Themes, DimTextCanBeReadWhereItStands) {
    for (const ImGuiCol style : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg, ImGuiCol_FrameBg,
                                 ImGuiCol_FrameBgHovered, ImGuiCol_Header, ImGuiCol_HeaderHovered})
        EXPECT_GE(contrast(unpack(color::dim), ground(style)), forText) << ImGui::GetStyleColorName(style);
}

TEST_P(Themes, CodeCanBeRead) {
    for (const ImU32 ink : {color::text, color::dim, color::faint, color::keyword, color::uniform}) {
        EXPECT_GE(contrast(unpack(ink), unpack(color::ground)), forText);
        EXPECT_GE(contrast(unpack(ink), unpack(color::panel)), forText);
    }
    for (const ImU32 behind : {color::blamed, color::lit})
        EXPECT_GE(contrast(unpack(color::text), over(behind, unpack(color::ground))), forText);
}

TEST_P(Themes, MarksCanBeReadAsText) {
    for (const Named& mark : marks) {
        const Rgb ink = unpack(palette().*mark.color);
        for (const ImGuiCol style : {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_MenuBarBg,
                                     ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
            EXPECT_GE(contrast(ink, ground(style)), forText)
                << mark.name << " on " << ImGui::GetStyleColorName(style);
        EXPECT_GE(contrast(ink, unpack(color::ground)), forText) << mark.name;
    }
}

TEST_P(Themes, WhatStandsOnAPictureCanBeReadWhateverItShows) {
    for (const Rgb picture : {Rgb{0, 0, 0}, Rgb{1, 1, 1}}) {
        const Rgb behind = over(color::shade, picture);
        EXPECT_GE(contrast(unpack(color::text), behind), forText);
        EXPECT_GE(contrast(unpack(color::dim), behind), forText);
        for (const Named& mark : marks)
            EXPECT_GE(contrast(unpack(palette().*mark.color), behind), forMarks) << mark.name;
    }
}

TEST_P(Themes, ControlsStandOut) {
    for (const ImGuiCol style : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_NavHighlight})
        EXPECT_GE(contrast(ground(style), ground(ImGuiCol_FrameBg)), forMarks)
            << ImGui::GetStyleColorName(style);
    EXPECT_GE(contrast(ground(ImGuiCol_ScrollbarGrab), ground(ImGuiCol_WindowBg)), forMarks);
}

TEST_P(Themes, MarksAreToldApartByEverybody) {
    constexpr double least = 12; // a difference of 2.3 is just noticeable
    for (const Vision& vision : visions) {
        for (std::size_t i = 0; i < marks.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GE(distance(labOf(palette().*marks[i].color, vision.matrix),
                                   labOf(palette().*marks[j].color, vision.matrix)),
                          least)
                    << marks[i].name << " and " << marks[j].name << " under " << vision.name;
        }
    }
}

TEST(HighContrast, HasMoreOfIt) {
    const Palette& palette = paletteOf(Theme::HighContrast);
    EXPECT_GE(contrast(unpack(palette.text), unpack(palette.panel)), 15);
    EXPECT_GE(contrast(unpack(palette.dim), unpack(palette.field)), 7); // 1.4.6, level AAA
}

TEST(ThemeColors, AreThoseOfTheThemeInForce) {
    usePalette(Theme::Light);
    const ImU32 light = color::text;
    usePalette(Theme::Dark);
    EXPECT_NE(light, static_cast<ImU32>(color::text));
    EXPECT_EQ(light, paletteOf(Theme::Light).text);
    EXPECT_EQ(componentColor(0), paletteOf(Theme::Dark).s);
    EXPECT_EQ(componentColor(9), paletteOf(Theme::Dark).q);
}

} // namespace
} // namespace texplorer::palette_test
