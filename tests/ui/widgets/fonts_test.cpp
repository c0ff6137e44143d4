#include "app/lettering/font_lettering.h"
#include "app/ui/state/details_tabs.h"
#include "app/ui/widgets/fonts.h"
#include "app/ui/widgets/theme.h"
#include "tests/ui/workbench.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

namespace texplorer::ui::fonts_test {
namespace {

constexpr float square = 4000; // of a window that shows all of a very long text

void append(std::string& text, unsigned letter) {
    std::array<char, 5> bytes{};
    ImTextCharToUtf8(bytes.data(), letter);
    text += bytes.data();
}

bool isDrawn(const ImFontGlyph& letter) {
    const ImDrawData& drawn = *ImGui::GetDrawData();
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        if (std::ranges::any_of(drawn.CmdLists[i]->VtxBuffer, [&](const ImDrawVert& vertex) {
                return vertex.uv.x == letter.U0 && vertex.uv.y == letter.V0;
            }))
            return true;
    }
    return false;
}

/// Whether a font has a picture of a letter within the atlas.
bool isLoaded(const ImFont& font, unsigned letter) {
    const ImFontGlyph* glyph = font.FindGlyphNoFallback(static_cast<ImWchar>(letter));
    return glyph && glyph->V0 >= 0 && glyph->V1 <= 1 && glyph->V1 > glyph->V0;
}

/// ImGui::GetFont() works only within a frame.
const ImFont& textFont() {
    return *ImGui::GetIO().Fonts->Fonts.front();
}

class LettersOfText : public testing::Test {
protected:
    LettersOfText() {
        ImGui::CreateContext();
        make();
    }
    ~LettersOfText() override { ImGui::DestroyContext(); }
    LettersOfText(const LettersOfText&) = delete;
    LettersOfText& operator=(const LettersOfText&) = delete;

    void make() {
        applyTheme(1, {}, nullptr, letters);
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    }
    /// Draws a frame with the text in both fonts. Returns true if the fonts were built again for the next
    /// one.
    bool draw(const std::string& text) {
        ImGui::GetIO().DisplaySize = {square, square};
        ImGui::NewFrame();
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        list.AddText({0, 0}, ~0U, text.c_str());
        list.AddText(codeFont(), codeFont()->FontSize, {0, 0}, ~0U, text.c_str());
        ImGui::Render();
        const bool lacks = letters.look(*ImGui::GetDrawData());
        if (lacks)
            make();
        return lacks;
    }

    Letters letters;
};

TEST_F(LettersOfText, AreLoadedTwoFramesAfterTheyWereFirstDrawn) {
    ASSERT_TRUE(hasLettersOf(Language::Chinese)) << "fonts-droid-fallback is not installed";
    const std::string name = "纹理.png שלום"; // of Droid, and of DejaVu
    EXPECT_FALSE(isLoaded(textFont(), U'纹'));
    EXPECT_TRUE(draw(name));
    EXPECT_TRUE(draw(name));
    EXPECT_FALSE(draw(name));
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts) {
        for (const unsigned letter : {U'纹', U'理', U'ש', U'ם'})
            EXPECT_TRUE(isLoaded(*font, letter)) << letter;
        EXPECT_FALSE(isDrawn(*font->FallbackGlyph));
    }
    EXPECT_TRUE(draw("图")) << "the next one";
    EXPECT_FALSE(draw("图"));
    EXPECT_TRUE(isLoaded(textFont(), U'图'));
    EXPECT_TRUE(isLoaded(textFont(), U'纹')) << "they stay";
}

TEST_F(LettersOfText, NeedAChineseFontForIdeographs) {
    EXPECT_TRUE(draw("שלום"));
    EXPECT_TRUE(draw("שלום"));
    EXPECT_FALSE(letters.needChineseFont());
    EXPECT_TRUE(draw("纹"));
    EXPECT_TRUE(letters.needChineseFont());
}

TEST_F(LettersOfText, ThatAreUsualCostNothing) {
    const int glyphs = textFont().Glyphs.Size;
    EXPECT_FALSE(draw("brick.png · Ключ · naïve · … ▶"));
    EXPECT_EQ(textFont().Glyphs.Size, glyphs);
}

TEST_F(LettersOfText, ThatNoFontHasAreReplacedByASignThatOneSees) {
    std::string text;
    append(text, 0xE8FF);       // for private use
    text += "\xF0\x9F\x98\x80"; // an emoji, beyond what Dear ImGui counts letters with
    EXPECT_TRUE(draw(text));
    EXPECT_TRUE(draw(text));
    EXPECT_FALSE(draw(text)) << "it is asked for once";
    const ImFont& font = textFont();
    EXPECT_EQ(font.FallbackChar, 0xFFFD);
    EXPECT_TRUE(font.FallbackGlyph->Visible);
    EXPECT_TRUE(isDrawn(*font.FallbackGlyph));
}

TEST_F(LettersOfText, AreNoMoreThanAnAtlasHasRoomFor) {
    std::string text;
    for (unsigned i = 0; i < 8000; ++i) { // the limit of a list, written twice
        append(text, 0x4E00 + i);
        if (i % 250 == 249)
            text += '\n';
    }
    EXPECT_TRUE(draw(text));
    EXPECT_TRUE(draw(text));
    EXPECT_FALSE(draw(text));
    EXPECT_FALSE(draw("図")) << "full";
    const ImFont& font = textFont();
    const auto loaded = std::ranges::count_if(font.Glyphs, [](const ImFontGlyph& glyph) {
        return glyph.Codepoint >= 0x4E00 && glyph.Codepoint < 0xE000 && glyph.V0 >= 0;
    });
    EXPECT_GT(loaded, 1000);
    EXPECT_LE(loaded, static_cast<std::ptrdiff_t>(maxLetters(font.FontSize)));
    EXPECT_LT(maxLetters(120), maxLetters(15));
}

using Names = test::Workbench;

TEST_F(Names, InAnyScriptAreShownByEveryPanelInEnglish) {
    Scene scene = defaultScene();
    scene.models[0].name = "立方体";
    scene.textures[0].source = SourceKind::File;
    scene.textures[0].file = "纹理图像.png";
    start(std::move(scene));
    for (const TabRow& tab : tabRows) {
        showTab(session->settings.workspace, tab.tab);
        frames(5);
        for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
            EXPECT_FALSE(isDrawn(*font->FallbackGlyph)) << tab.name;
    }
    for (const unsigned letter : {U'立', U'纹', U'图'})
        EXPECT_TRUE(isLoaded(textFont(), letter)) << letter;
}

// Letters of pictures without a window.
TEST(LettersOfSheets, AreThoseOfTheName) {
    const std::unique_ptr<sheet::Lettering> lettering = openLettering().value();
    const auto written = [&](std::string_view text) {
        Image picture = Image::uninitialised(PixelFormat::Rgb8, 40, 30);
        std::ranges::fill(picture.pixels, std::byte{0});
        lettering->draw(picture, 5, 2, sheet::TextRole::Title, text, {255, 255, 255});
        return picture;
    };
    EXPECT_NE(written("纹"), written("理"));
    EXPECT_NE(written("纹"), written("?"));
    EXPECT_GT(lettering->width(sheet::TextRole::Title, "纹理"),
              lettering->width(sheet::TextRole::Title, "纹"));
}

} // namespace
} // namespace texplorer::ui::fonts_test
