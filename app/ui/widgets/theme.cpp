#include "app/ui/widgets/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace texplorer::ui {
namespace {

constexpr float textSize = 15; // pixels at a content scale of 1
constexpr float codeSize = 13.5F;

// Where distributions keep DejaVu: Debian, Fedora, Arch.
constexpr std::array fontFolders{"/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/dejavu-sans-fonts/",
                                 "/usr/share/fonts/dejavu-sans-mono-fonts/", "/usr/share/fonts/TTF/"};

// File names may be written in any of these; the rest are the signs that the panels use.
constexpr std::array<ImWchar, 19> glyphs{0x0020, 0x024F, // Latin
                                         0x0370, 0x03FF, // Greek
                                         0x0400, 0x04FF, // Cyrillic
                                         0x2010, 0x2026, // dashes, quotation marks, …
                                         0x2190, 0x2199, // arrows
                                         0x21BA, 0x21BB, // ↺ ↻
                                         0x25A0, 0x25CF, // ▶ ▾ ●
                                         0x2715, 0x275A, // ✕ ❚
                                         0x2212, 0x2212, // −
                                         0};

ImFont* addFont(const char* file, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    for (const char* folder : fontFolders) {
        const std::string path = std::string(folder) + file;
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored))
            continue;
        ImFontConfig config;
        config.OversampleH = 2;
        config.OversampleV = 1;
        config.PixelSnapH = true;
        if (ImFont* font = atlas.AddFontFromFileTTF(path.c_str(), size, &config, glyphs.data()))
            return font;
    }
    ImFontConfig config;
    config.SizePixels = std::round(size * 13 / textSize);
    return atlas.AddFontDefault(&config);
}

ImVec4 grey(int red, int green, int blue, float alpha = 1) {
    return {static_cast<float>(red) / 255, static_cast<float>(green) / 255, static_cast<float>(blue) / 255,
            alpha};
}

void setColors(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    ImVec4* c = style.Colors;
    const ImVec4 panel = grey(30, 33, 39);
    const ImVec4 field = grey(49, 54, 63);
    const ImVec4 fieldHover = grey(60, 66, 77);
    const ImVec4 fieldActive = grey(70, 78, 92);
    const ImVec4 accent = grey(118, 150, 190);
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(color::text);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(color::dim);
    c[ImGuiCol_WindowBg] = panel;
    c[ImGuiCol_ChildBg] = grey(0, 0, 0, 0);
    c[ImGuiCol_PopupBg] = grey(34, 38, 45);
    c[ImGuiCol_Border] = grey(64, 70, 80);
    c[ImGuiCol_FrameBg] = field;
    c[ImGuiCol_FrameBgHovered] = fieldHover;
    c[ImGuiCol_FrameBgActive] = fieldActive;
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(44, 49, 57);
    c[ImGuiCol_MenuBarBg] = grey(24, 26, 31);
    c[ImGuiCol_ScrollbarBg] = grey(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = grey(70, 77, 89);
    c[ImGuiCol_ScrollbarGrabHovered] = grey(88, 97, 112);
    c[ImGuiCol_ScrollbarGrabActive] = accent;
    c[ImGuiCol_CheckMark] = grey(158, 194, 240);
    c[ImGuiCol_SliderGrab] = accent;
    c[ImGuiCol_SliderGrabActive] = grey(158, 194, 240);
    c[ImGuiCol_Button] = field;
    c[ImGuiCol_ButtonHovered] = fieldHover;
    c[ImGuiCol_ButtonActive] = fieldActive;
    c[ImGuiCol_Header] = grey(52, 60, 72);
    c[ImGuiCol_HeaderHovered] = grey(62, 72, 86);
    c[ImGuiCol_HeaderActive] = grey(72, 84, 101);
    c[ImGuiCol_Separator] = grey(52, 57, 66);
    c[ImGuiCol_SeparatorHovered] = accent;
    c[ImGuiCol_SeparatorActive] = accent;
    c[ImGuiCol_Tab] = panel;
    c[ImGuiCol_TabHovered] = fieldHover;
    c[ImGuiCol_TabActive] = field;
    c[ImGuiCol_TabUnfocused] = panel;
    c[ImGuiCol_TabUnfocusedActive] = field;
    c[ImGuiCol_TableHeaderBg] = panel;
    c[ImGuiCol_TableRowBgAlt] = grey(255, 255, 255, 0.02F);
    c[ImGuiCol_TextSelectedBg] = grey(70, 96, 132);
    c[ImGuiCol_NavHighlight] = accent;
    c[ImGuiCol_ModalWindowDimBg] = grey(8, 9, 12, 0.55F);
}

} // namespace

ImU32 componentColor(int component) {
    constexpr std::array colors{color::s, color::t, color::r, color::q};
    return colors[static_cast<std::size_t>(std::clamp(component, 0, 3))];
}

void applyTheme(float scale) {
    scale = std::clamp(scale, 0.5F, 8.0F);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.Fonts->Clear();
    addFont("DejaVuSans.ttf", std::round(textSize * scale));
    addFont("DejaVuSansMono.ttf", std::round(codeSize * scale));

    ImGuiStyle style;
    setColors(style);
    style.WindowPadding = {10, 8};
    style.FramePadding = {7, 3};
    style.CellPadding = {4, 2};
    style.ItemSpacing = {8, 4};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 10;
    style.WindowBorderSize = 0;
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
    ImGui::GetStyle() = style;
}

ImFont* codeFont() {
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    return fonts.Size > 1 ? fonts[1] : ImGui::GetFont();
}

} // namespace texplorer::ui
