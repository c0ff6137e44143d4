#include "app/lettering/font_lettering.h"

#include "app/view/font_folders.h"
#include "texplorer/text/utf8.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <utility>

namespace texplorer {
namespace {

using sheet::Ink;
using sheet::TextRole;

constexpr std::array fontFiles{"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};

/// How each role is written.
struct Style {
    std::size_t font; ///< of fontFiles
    unsigned size;    ///< pixels
};
constexpr std::array<Style, sheet::textRoleCount> styles{{{0, 20}, {1, 14}, {0, 14}, {0, 13}}};

constexpr const Style& styleOf(TextRole role) {
    return styles[static_cast<std::size_t>(role)];
}

/// From one line's baseline to the next, of its size: DejaVu's own is 1.16.
constexpr int lineHeightOf(unsigned size) {
    return static_cast<int>((size * 5 + 3) / 4);
}

/// In FreeType's numbers of 1/64, a whole pixel is this.
constexpr FT_Pos one = 64;

class FontLettering : public sheet::Lettering {
public:
    ~FontLettering() override {
        for (FT_Face face : faces_) {
            if (face != nullptr)
                FT_Done_Face(face);
        }
        if (further_ != nullptr)
            FT_Done_Face(further_);
        if (library_ != nullptr)
            FT_Done_FreeType(library_);
    }
    FontLettering() = default;
    FontLettering(const FontLettering&) = delete;
    FontLettering& operator=(const FontLettering&) = delete;

    /// The fonts that aren't open yet, if the folder has them; whether all are.
    bool open(const std::string& folder) {
        if (library_ == nullptr && FT_Init_FreeType(&library_) != 0)
            return false;
        for (std::size_t i = 0; i < faces_.size(); ++i) {
            if (faces_[i] == nullptr &&
                FT_New_Face(library_, (folder + fontFiles[i]).c_str(), 0, &faces_[i]) != 0)
                faces_[i] = nullptr;
        }
        return std::ranges::find(faces_, nullptr) == faces_.end();
    }

    /// A font for the letters that those lack, where there is one.
    void openFurther() {
        for (const view::ChineseFont& font : view::chineseFonts) {
            if (FT_New_Face(library_, font.file, 0, &further_) == 0)
                return;
            further_ = nullptr;
        }
    }

    [[nodiscard]] int width(TextRole role, std::string_view text) const override {
        const std::scoped_lock lock(mutex_);
        const FT_Pos end = walk(role, text, [](FT_GlyphSlot, FT_Pos) {});
        return static_cast<int>((end + one - 1) / one);
    }

    [[nodiscard]] int lineHeight(TextRole role) const override { return lineHeightOf(styleOf(role).size); }

    void draw(Image& picture, int left, int top, TextRole role, std::string_view text,
              Ink ink) const override {
        const std::scoped_lock lock(mutex_);
        const int baseline = top + static_cast<int>(styleOf(role).size); // ascenders are 0.93 of it
        walk(role, text, [&](FT_GlyphSlot glyph, FT_Pos at) {
            FT_Outline_Translate(&glyph->outline, at % one, 0);
            if (FT_Render_Glyph(glyph, FT_RENDER_MODE_NORMAL) != 0)
                return;
            blend(picture, left + static_cast<int>(at / one) + glyph->bitmap_left,
                  baseline - glyph->bitmap_top, glyph->bitmap, ink);
        });
    }

private:
    /// Calls visit(letter, at) for each, and returns where the next would stand. Letters
    /// stand between pixels where their widths say so.
    template<class Visit>
    FT_Pos walk(TextRole role, std::string_view text, const Visit& visit) const {
        FT_Face usual = faces_.at(styleOf(role).font);
        for (FT_Face face : {usual, further_}) {
            if (face != nullptr)
                FT_Set_Pixel_Sizes(face, 0, styleOf(role).size);
        }
        FT_Pos at = 0;
        FT_UInt before = 0; // a letter of the usual font
        while (!text.empty()) {
            const Utf8Character next = firstCharacter(text);
            text.remove_prefix(std::max<std::size_t>(1, next.bytes));
            const auto [face, glyph] = letterOf(usual, next.bytes == 0 ? U'\uFFFD' : next.character);
            FT_Vector kerning{0, 0};
            const FT_UInt kerned = face == usual ? glyph : 0;
            if (before != 0 && kerned != 0)
                FT_Get_Kerning(usual, before, kerned, FT_KERNING_UNFITTED, &kerning);
            before = kerned;
            if (FT_Load_Glyph(face, glyph, FT_LOAD_TARGET_LIGHT | FT_LOAD_NO_BITMAP) != 0)
                continue;
            at = std::max<FT_Pos>(0, at + kerning.x);
            const FT_Pos advance = face->glyph->linearHoriAdvance / 1024; // 16.16 to 26.6
            visit(face->glyph, at);
            at += advance;
        }
        return at;
    }

    [[nodiscard]] std::pair<FT_Face, FT_UInt> letterOf(FT_Face usual, char32_t character) const {
        const FT_UInt glyph = FT_Get_Char_Index(usual, character);
        if (glyph != 0 || further_ == nullptr)
            return {usual, glyph};
        const FT_UInt other = FT_Get_Char_Index(further_, character);
        return other != 0 ? std::pair(further_, other) : std::pair(usual, glyph);
    }

    static void blend(Image& picture, int left, int top, const FT_Bitmap& bitmap, Ink ink) {
        for (int y = 0; y < static_cast<int>(bitmap.rows); ++y) {
            for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
                if (left + x < 0 || left + x >= picture.width || top + y < 0 || top + y >= picture.height)
                    continue;
                const unsigned char* covered = bitmap.buffer + std::ptrdiff_t{y} * bitmap.pitch + x;
                const std::span<std::byte> pixel = picture.at(left + x, picture.height - 1 - (top + y));
                for (std::size_t i = 0; i < ink.size(); ++i) {
                    const int below = std::to_integer<int>(pixel[i]);
                    pixel[i] = static_cast<std::byte>(below + ((ink[i] - below) * *covered + 127) / 255);
                }
            }
        }
    }

    mutable std::mutex mutex_; // a face has one size and one slot
    FT_Library library_ = nullptr;
    std::array<FT_Face, fontFiles.size()> faces_{};
    FT_Face further_ = nullptr;
};

} // namespace

Result<std::unique_ptr<sheet::Lettering>> openLettering() {
    auto lettering = std::make_unique<FontLettering>();
    std::string folders;
    for (const char* folder : view::fontFolders) {
        if (lettering->open(folder)) {
            lettering->openFurther();
            return lettering;
        }
        folders.append(folders.empty() ? "" : ", ").append(folder);
    }
    return fail(ErrorCode::NotFound,
                std::string("expected the fonts ")
                    .append(fontFiles[0])
                    .append(" and ")
                    .append(fontFiles[1])
                    .append(" in one of ")
                    .append(folders),
                "labels");
}

} // namespace texplorer
