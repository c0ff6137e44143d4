#include "app/ui/widgets/theme.h"

#include "app/ui/widgets/font_file.h"
#include "app/view/font_folders.h"
#include "core/lesson/lesson_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr float textSize = 15; // pixels at a scale of 1
constexpr float codeSize = 13.5F;

// File names may be written in any of these; the rest are the signs that the panels use.
constexpr std::array<ImWchar, 19> glyphs{0x0020, 0x024F, // Latin
                                         0x0370, 0x03FF, // Greek
                                         0x0400, 0x04FF, // Cyrillic
                                         0x2010, 0x203A, // dashes, quotation marks, … ›
                                         0x2190, 0x2199, // arrows
                                         0x21BA, 0x21BB, // ↺ ↻
                                         0x25A0, 0x25CF, // ▶ ▾ ●
                                         0x2715, 0x275A, // ✕ ❚
                                         0x2212, 0x2212, // −
                                         0};

/// A font with Chinese letters. They are to be as large as DejaVu's, which leaves less of a line's height
/// free.
struct ChineseFont {
    const char* file;
    float lineHeight; ///< in its em; DejaVu's is 1.164
};

// Debian's fonts-droid-fallback, fonts-wqy-microhei and fonts-noto-cjk, Fedora's and Arch's Noto.
constexpr std::array chineseFonts{
    ChineseFont{"/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", 1.309F},
    ChineseFont{"/usr/share/fonts/truetype/wqy/wqy-microhei.ttc", 1.17F},
    ChineseFont{"/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 1.448F},
    ChineseFont{"/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc", 1.448F},
    ChineseFont{"/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc", 1.448F}};
constexpr float usualLineHeight = 1.164F;

const ChineseFont* chineseFont() {
    const auto isThere = [](const ChineseFont& font) { return isFontFile(font.file); };
    const auto found = std::ranges::find_if(chineseFonts, isThere);
    return found == chineseFonts.end() ? nullptr : &*found;
}

/// The letters of the language's texts, where the usual fonts lack them: empty where they don't. All that the
/// font has would take an atlas of 16 MB at large sizes.
std::vector<ImWchar> furtherLetters(const Catalogue* catalogue) {
    if (!catalogue || catalogue->language() != Language::Chinese || !chineseFont())
        return {};
    ImFontGlyphRangesBuilder letters;
    const auto add = [&letters](std::string_view text) {
        letters.AddText(text.data(), text.data() + text.size());
    };
    add(catalogue->letters());
    const std::string name = std::string(rowOf(catalogue->language()).name) + ".po";
    for (const lesson::LessonFile& file : lesson::lessonFiles()) {
        if (file.name.ends_with(name))
            add(file.text);
    }
    ImVector<ImWchar> ranges;
    letters.BuildRanges(&ranges);
    return {ranges.begin(), ranges.end()};
}

/// Adds them to the font before this, which keeps a pointer to them.
void addLetters(const std::vector<ImWchar>& ranges, float size) {
    if (ranges.empty())
        return;
    ImFontConfig config;
    config.MergeMode = true;
    config.PixelSnapH = true;
    config.OversampleH = 1;
    const ChineseFont* font = chineseFont();
    if (!font)
        return; // it has gone meanwhile
    ImGui::GetIO().Fonts->AddFontFromFileTTF(
        font->file, std::round(size * font->lineHeight / usualLineHeight), &config, ranges.data());
}

ImFont* addFont(const char* file, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    for (const char* folder : view::fontFolders) {
        const std::string path = std::string(folder) + file;
        if (!isFontFile(path))
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

/// Which colour of the palette each of Dear ImGui's is.
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
    const int percent = std::clamp(textPercent, Settings::smallestText, Settings::largestText);
    return std::clamp(contentScale * static_cast<float>(percent) / 100, 0.5F, 8.0F);
}

bool hasLettersOf(Language language) {
    return language != Language::Chinese || chineseFont();
}

void applyTheme(float contentScale, Theme theme, int textPercent, const Catalogue* catalogue) {
    const float scale = textScale(contentScale, textPercent);
    usePalette(theme);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.Fonts->Clear();
    static std::vector<ImWchar> letters; // of the atlas, which is built with the next frame
    letters = furtherLetters(catalogue);
    addFont("DejaVuSans.ttf", std::round(textSize * scale));
    addLetters(letters, std::round(textSize * scale));
    addFont("DejaVuSansMono.ttf", std::round(codeSize * scale));
    addLetters(letters, std::round(codeSize * scale));

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
    style.FrameBorderSize =
        theme == Theme::Dark ? 0 : 1; // fields are as white, or as black, as what is around
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
