#include "app/ui/widgets/theme.h"

#include "app/ui/widgets/wrapped_text.h"

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

/// The palette's colour for each of Dear ImGui's.
struct StyleRow {
    ImGuiCol style;
    ImU32 Palette::*color;
};

constexpr std::array styleRows{
    StyleRow{ImGuiCol_Text, &Palette::text},
    StyleRow{ImGuiCol_TextDisabled, &Palette::dim},
    StyleRow{ImGuiCol_WindowBg, &Palette::panel},
    StyleRow{ImGuiCol_PopupBg, &Palette::popup},
    StyleRow{ImGuiCol_Border, &Palette::border},
    StyleRow{ImGuiCol_FrameBg, &Palette::field},
    StyleRow{ImGuiCol_FrameBgHovered, &Palette::fieldHover},
    StyleRow{ImGuiCol_FrameBgActive, &Palette::fieldActive},
    StyleRow{ImGuiCol_TitleBg, &Palette::title},
    StyleRow{ImGuiCol_TitleBgActive, &Palette::title},
    StyleRow{ImGuiCol_TitleBgCollapsed, &Palette::title},
    StyleRow{ImGuiCol_MenuBarBg, &Palette::bar},
    StyleRow{ImGuiCol_ScrollbarGrab, &Palette::grab},
    StyleRow{ImGuiCol_ScrollbarGrabHovered, &Palette::accent},
    StyleRow{ImGuiCol_ScrollbarGrabActive, &Palette::accent},
    StyleRow{ImGuiCol_CheckMark, &Palette::accent},
    StyleRow{ImGuiCol_SliderGrab, &Palette::accent},
    StyleRow{ImGuiCol_SliderGrabActive, &Palette::accent},
    StyleRow{ImGuiCol_Button, &Palette::field},
    StyleRow{ImGuiCol_ButtonHovered, &Palette::fieldHover},
    StyleRow{ImGuiCol_ButtonActive, &Palette::fieldActive},
    StyleRow{ImGuiCol_Header, &Palette::header},
    StyleRow{ImGuiCol_HeaderHovered, &Palette::headerHover},
    StyleRow{ImGuiCol_HeaderActive, &Palette::headerActive},
    StyleRow{ImGuiCol_Separator, &Palette::separator},
    StyleRow{ImGuiCol_SeparatorHovered, &Palette::accent},
    StyleRow{ImGuiCol_SeparatorActive, &Palette::accent},
    StyleRow{ImGuiCol_ResizeGrip, &Palette::grab},
    StyleRow{ImGuiCol_ResizeGripHovered, &Palette::accent},
    StyleRow{ImGuiCol_ResizeGripActive, &Palette::accent},
    StyleRow{ImGuiCol_Tab, &Palette::panel},
    StyleRow{ImGuiCol_TabHovered, &Palette::fieldHover},
    StyleRow{ImGuiCol_TabActive, &Palette::field},
    StyleRow{ImGuiCol_TabUnfocused, &Palette::panel},
    StyleRow{ImGuiCol_TabUnfocusedActive, &Palette::field},
    StyleRow{ImGuiCol_PlotLines, &Palette::accent},
    StyleRow{ImGuiCol_PlotHistogram, &Palette::accent},
    StyleRow{ImGuiCol_TableHeaderBg, &Palette::panel},
    StyleRow{ImGuiCol_TableBorderStrong, &Palette::border},
    StyleRow{ImGuiCol_TableBorderLight, &Palette::separator},
    StyleRow{ImGuiCol_TextSelectedBg, &Palette::selection},
    StyleRow{ImGuiCol_NavHighlight, &Palette::accent},
    StyleRow{ImGuiCol_ModalWindowDimBg, &Palette::curtain},
};

/// Sizes of controls, unscaled.
struct Metrics {
    ImVec2 framePadding, itemSpacing, cellPadding;
    float touchPadding; ///< how far a control reaches beyond its frame: half of the spacing at most
    float targetHeight;
    float scrollbar, grab;
};
const Metrics smallMetrics{{7, 3}, {8, 4}, {4, 2}, 0, 0, 12, 10};
const Metrics largeMetrics{{9, 12}, {8, 4}, {4, 2}, 2, 40, 18, 24};

float targetPixels = 0; // see targetHeight

void setColors(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    for (const StyleRow& row : styleRows)
        style.Colors[row.style] = ImGui::ColorConvertU32ToFloat4(palette().*row.color);
    for (const ImGuiCol none : {ImGuiCol_ChildBg, ImGuiCol_ScrollbarBg, ImGuiCol_TableRowBg})
        style.Colors[none] = {};
    ImVec4 stripe = ImGui::ColorConvertU32ToFloat4(palette().text);
    stripe.w = 0.02F;
    style.Colors[ImGuiCol_TableRowBgAlt] = stripe;
}

} // namespace

float textScale(float contentScale, int textPercent) {
    const int percent = std::clamp(textPercent, Settings::minText, Settings::maxText);
    return std::clamp(contentScale * static_cast<float>(percent) / 100, 0.5F, 8.0F);
}

Appearance appearanceOf(const Settings& settings) {
    return {settings.theme, settings.textPercent, settings.largeControls};
}

float targetHeight() {
    return targetPixels;
}

void applyTheme(float contentScale, const Appearance& appearance, const Catalogue* catalogue,
                const Letters& letters) {
    const float scale = textScale(contentScale, appearance.textPercent);
    const Metrics& metrics = appearance.largeControls ? largeMetrics : smallMetrics;
    usePalette(appearance.theme);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    addFonts(scale, catalogue, letters);
    forgetWrappedTexts();

    ImGuiStyle style;
    setColors(style);
    style.WindowPadding = {10, 8};
    style.FramePadding = metrics.framePadding;
    style.CellPadding = metrics.cellPadding;
    style.ItemSpacing = metrics.itemSpacing;
    style.TouchExtraPadding = {metrics.touchPadding, metrics.touchPadding};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = metrics.scrollbar;
    style.GrabMinSize = metrics.grab;
    style.WindowBorderSize = 0;
    style.FrameBorderSize =
        appearance.theme == Theme::Dark ? 0 : 1; // fields are as white, or as black, as what is around
    style.PopupBorderSize = 1;
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.PopupRounding = 4;
    style.ScrollbarRounding = 6;
    style.GrabRounding = 3;
    style.TabRounding = 3;
    style.WindowMinSize = {8, 8};
    style.DisabledAlpha = 0.45F;
    style.ScaleAllSizes(scale);
    targetPixels = metrics.targetHeight * scale;
    ImGui::GetStyle() = style;
}

} // namespace texplorer::ui
