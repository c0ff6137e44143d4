#include "app/ui/widgets/fonts.h"

#include "app/view/font_folders.h"
#include "texplorer/lesson/lesson_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr float textSize = 15; // pixels at a scale of 1
constexpr float codeSize = 13.5F;

constexpr std::array<ImWchar, 23> usualLetters{0x0020, 0x024F, // Latin
                                               0x0370, 0x03FF, // Greek
                                               0x0400, 0x04FF, // Cyrillic
                                               0x2010, 0x203A, // dashes, quotation marks, … ›
                                               0x2190, 0x2199, // arrows
                                               0x21BA, 0x21BB, // ↺ ↻
                                               0x25A0, 0x25CF, // ▶ ▾ ●
                                               0x2715, 0x275A, // ✕ ❚
                                               0x2212, 0x2212, // −
                                               0x2264, 0x2264, // ≤
                                               0xFFFD, 0xFFFD, // shown for a letter that no font has
                                               0};

const view::ChineseFont* chineseFont() {
    const auto isThere = [](const view::ChineseFont& font) { return isFontFile(font.file); };
    const auto found = std::ranges::find_if(view::chineseFonts, isThere);
    return found == view::chineseFonts.end() ? nullptr : &*found;
}

std::optional<std::string> dejaVu(const char* file) {
    for (const char* folder : view::fontFolders) {
        std::string path = std::string(folder) + file;
        if (isFontFile(path))
            return path;
    }
    return std::nullopt;
}

/// The letters of the language's texts that DejaVu lacks. All letters of the font would need an atlas of 16
/// MB at large sizes.
void addLettersOf(const Catalogue* catalogue, ImFontGlyphRangesBuilder& letters) {
    if (!catalogue || catalogue->language() != Language::Chinese)
        return;
    const auto add = [&letters](std::string_view text) {
        letters.AddText(text.data(), text.data() + text.size());
    };
    add(catalogue->letters());
    const std::string name = std::string(rowOf(catalogue->language()).name) + ".po";
    for (const lesson::LessonFile& file : lesson::lessonFiles()) {
        if (file.name.ends_with(name))
            add(file.text);
    }
}

/// Adds the missing letters to the previous font.
void mergeFont(const std::string& file, float size, const ImVector<ImWchar>& letters) {
    ImFontConfig config;
    config.MergeMode = true;
    config.PixelSnapH = true;
    config.OversampleH = 1;
    ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), std::round(size), &config, letters.Data);
}

void addFont(const char* file, float size) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.PixelSnapH = true;
    if (const std::optional<std::string> path = dejaVu(file)) {
        config.OversampleH = 2;
        config.OversampleV = 1;
        atlas.AddFontFromFileTTF(path->c_str(), size, &config, usualLetters.data());
    } else {
        config.SizePixels = std::round(size * 13 / textSize);
        atlas.AddFontDefault(&config);
    }
}

// A letter that is not loaded has a placeholder whose texture coordinates identify it: nothing else that is
// drawn has this v, and its u is the letter.
constexpr float ofStandIn = -1e6F;

void addStandIns(ImFont& font, const std::set<ImWchar>& asked) {
    constexpr unsigned firstLetter = 0x80;
    constexpr unsigned endOfPlane = 0xFFFF;
    const auto isSurrogate = [](unsigned letter) { return letter >= 0xD800 && letter < 0xE000; };
    font.Glyphs.reserve(static_cast<int>(endOfPlane));
    for (unsigned each = firstLetter; each < endOfPlane; ++each) {
        const auto letter = static_cast<ImWchar>(each);
        if (isSurrogate(each) || asked.contains(letter) || font.FindGlyphNoFallback(letter))
            continue;
        const auto u = static_cast<float>(letter);
        font.AddGlyph(nullptr, letter, 0, 0, font.FontSize, font.FontSize, u, ofStandIn, u, ofStandIn,
                      font.FontSize);
    }
    font.BuildLookupTable();
}

bool drawsUnknownLetters(const ImDrawList& list) {
    return std::ranges::any_of(ImGui::GetIO().Fonts->Fonts, [&list](const ImFont* font) {
        const ImFontGlyph& unknown = *font->FallbackGlyph;
        return std::ranges::any_of(list.VtxBuffer, [&unknown](const ImDrawVert& vertex) {
            return vertex.uv.x == unknown.U0 && vertex.uv.y == unknown.V0;
        });
    });
}

} // namespace

bool Letters::look(const ImDrawData& drawn) {
    const std::size_t before = asked_.size();
    const std::size_t max = maxLetters(ImGui::GetIO().Fonts->Fonts.front()->FontSize);
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const ImDrawList& list = *drawn.CmdLists[i];
        if (!told_ && drawsUnknownLetters(list))
            return told_ = true;
        for (const ImDrawVert& vertex : list.VtxBuffer) {
            if (vertex.uv.y == ofStandIn && asked_.size() < max)
                asked_.insert(static_cast<ImWchar>(vertex.uv.x));
        }
    }
    return asked_.size() > before;
}

bool Letters::needChineseFont() const {
    constexpr ImWchar firstRadical = 0x2E80;
    return asked_.lower_bound(firstRadical) != asked_.end();
}

std::size_t maxLetters(float size) {
    constexpr float atlasPixels = 16e6F;
    constexpr float atAnySize = 4096;
    return static_cast<std::size_t>(std::min(atAnySize, atlasPixels / (2 * size * size)));
}

void addFonts(float scale, const Catalogue* catalogue, const Letters& letters) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    ImFontGlyphRangesBuilder further;
    addLettersOf(catalogue, further);
    std::size_t left =
        maxLetters(std::round(textSize * scale)); // they may have been requested at a smaller size
    for (const ImWchar letter : letters.asked_) {
        if (left-- == 0)
            break;
        further.AddChar(letter);
    }
    static ImVector<ImWchar> ranges; // the atlas keeps pointers to it until it is built
    ranges.clear();
    further.BuildRanges(&ranges);
    const bool hasFurther = ranges.Size > 1; // it ends with 0
    const std::optional<std::string> sans = hasFurther ? dejaVu("DejaVuSans.ttf") : std::nullopt;
    const view::ChineseFont* chinese = hasFurther ? chineseFont() : nullptr;
    for (const auto& [file, unscaled] :
         {std::pair("DejaVuSans.ttf", textSize), std::pair("DejaVuSansMono.ttf", codeSize)}) {
        const float size = std::round(unscaled * scale);
        addFont(file, size);
        if (sans)
            mergeFont(*sans, size, ranges);
        if (chinese)
            mergeFont(chinese->file, size * chinese->lineHeight / view::dejaVuLineHeight, ranges);
    }
    if (!letters.told_)
        return;
    atlas.Build();
    for (ImFont* font : atlas.Fonts) {
        if (letters.asked_.size() < maxLetters(font->FontSize))
            addStandIns(*font, letters.asked_);
    }
}

bool hasLettersOf(Language language) {
    return language != Language::Chinese || chineseFont();
}

ImFont* codeFont() {
    const ImVector<ImFont*>& fonts = ImGui::GetIO().Fonts->Fonts;
    return fonts.Size > 1 ? fonts[1] : ImGui::GetFont();
}

} // namespace texplorer::ui
