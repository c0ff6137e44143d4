// The window in every language: nothing that it shows stays English but what has to.

#include "app/ui/state/details_tabs.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/theme.h"
#include "tests/ui/workbench.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>
#include <imgui_internal.h>

#include <regex>

namespace texplorer::language_window_test {
namespace {

using namespace ui;

constexpr std::array languages{Language::Chinese, Language::Russian};

/// What is the same in every language: OpenGL's names, formulas, units, formats, names of files.
bool isOfNoLanguage(const std::string& text) {
    static const std::regex word("[A-Za-z][A-Za-z0-9]{2,}");
    static const std::regex sameEverywhere(
        "GL|GLSL|GLU|RGBA?[0-9]*|F[0-9]+|RGB565|BGRA?|DXT[135]|S3TC|ATI[12]|BC[1-7]|BMP|TGA|DDS|PNG|JPEG|JSON|XYZ|sRGB|Texplorer|"
        "llvmpipe|softpipe|LLVM|OpenGL|OSMesa|Mesa|mipmap|LOD|KiB|MiB|bytes?|Ctrl|Shift|Alt|Esc|Enter|Tab|Del|Home|"
        "End|none|float|void|vec[234]|mat4|const|uniform|texture|Arg[012]|DECAL|glColor|glRotatef|rho|lambda|cos|sin|"
        "floor|frac|clamp|max|min|abs|dot|tex|env|rgb|alpha|true|false|cube|json|png|bmp|dds|tga|the");
    for (std::sregex_iterator match(text.begin(), text.end(), word), end; match != end; ++match) {
        const auto before =
            match->position() > 0 ? text[static_cast<std::size_t>(match->position()) - 1] : ' ';
        if (before == '_' || match->str().starts_with("gl") || before == '.' || before == '[')
            continue;
        if (!std::regex_match(match->str(), sameEverywhere) && match->str() != "GL")
            return text.find("GL_") != std::string::npos && text.find(' ') == std::string::npos;
    }
    return true;
}

std::string listOf(const std::set<std::string, std::less<>>& gaps) {
    std::string list;
    for (const std::string& gap : gaps) {
        if (!isOfNoLanguage(gap))
            list += "\n  " + gap;
    }
    return list;
}

void lookUp(const Catalogue& catalogue, std::string_view text, std::set<std::string, std::less<>>& gaps) {
    if (!text.empty() && !catalogue.find(text))
        gaps.emplace(text);
}

void lookUp(const Catalogue& catalogue, const StructTable& table, std::set<std::string, std::less<>>& gaps) {
    for (const ParamRow& row : table.params) {
        for (const std::string_view text : {row.label, row.help, row.group})
            lookUp(catalogue, text, gaps);
        for (const EnumRow& choice : row.choices) {
            for (const std::string_view text : {choice.label, choice.help, choice.group, choice.brief})
                lookUp(catalogue, text, gaps);
        }
    }
    for (const ChildRow& child : table.children) {
        lookUp(catalogue, child.label, gaps);
        lookUp(catalogue, *child.table, gaps);
    }
}

class Languages : public test::Workbench, public testing::WithParamInterface<Language> {};

TEST_P(Languages, HaveEveryRowOfTheTables) {
    const auto catalogue = catalogueOf(GetParam()).value();
    std::set<std::string, std::less<>> gaps;
    lookUp(*catalogue, sceneTable(), gaps);
    for (std::size_t i = 0; i < 4; ++i)
        lookUp(*catalogue, texGenTable(i), gaps);
    EXPECT_EQ(listOf(gaps), "");
}

TEST_P(Languages, HaveALetterForEverySignThatIsShown) {
    speak(GetParam());
    ASSERT_TRUE(hasLettersOf(GetParam())) << "fonts-droid-fallback is not installed";
    frames();
    const std::string& letters = catalogueInUse()->letters();
    const ImFont& font = *ImGui::GetFont();
    for (const char* at = letters.c_str(); *at != 0;) {
        unsigned int letter = 0;
        const auto bytes = static_cast<std::size_t>(ImTextCharFromUtf8(&letter, at, nullptr));
        const bool isSeen = letter > ' ';
        ASSERT_TRUE(!isSeen || font.FindGlyphNoFallback(static_cast<ImWchar>(letter)))
            << std::string(at, bytes);
        at += bytes;
    }
}

// The atlas keeps pointers to them until it is built.
TEST_P(Languages, HaveLettersThatLiveAsLongAsTheirFonts) {
    speak(GetParam());
    frames();
    std::set<const ImWchar*> merged;
    for (const ImFontConfig& font : ImGui::GetIO().Fonts->ConfigData) {
        if (font.MergeMode)
            merged.insert(font.GlyphRanges);
    }
    EXPECT_EQ(merged.size(), GetParam() == Language::Chinese ? 1U : 0U) << "one list, for text and for code";
}

TEST_P(Languages, AreSpokenByEveryPanel) {
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    for (const auto& [width, height, scale] : {std::tuple(1280, 800, 1.0F), std::tuple(3840, 2160, 2.0F)}) {
        start(defaultScene(), width, height, scale);
        for (const TabRow& tab : tabRows) {
            showTab(session->settings.workspace, tab.tab);
            session->look.explaining.pixel = {width / 6, height / 5};
            frames(3);
        }
    }
    EXPECT_EQ(listOf(gaps), "");
}

TEST_P(Languages, AreSpokenByEveryMenu) {
    std::set<std::string, std::less<>> gaps;
    speak(GetParam(), &gaps);
    for (const char* menu :
         {"menu:File", "menu:Edit", "menu:View", "menu:Presets", "menu:A/B", "menu:Help"}) {
        click(menu);
        frames(2);
        EXPECT_TRUE(ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
            << menu;
        key(ui::key::escape);
    }
    for (int step = 0; step < tourSteps; ++step) {
        session->window.tour = step;
        frames(2);
    }
    EXPECT_EQ(listOf(gaps), "");
}

TEST(LanguagesOfTabs, KeepTheTimelineAndTheKeyboardApart) {
    const auto russian = catalogueOf(Language::Russian).value();
    EXPECT_EQ(textIn(russian.get(), "Keys"), "Клавиши") << "of the keyboard";
    EXPECT_EQ(textIn(russian.get(), rowOf(Tab::Timeline).brief), "Время");
    const auto chinese = catalogueOf(Language::Chinese).value();
    EXPECT_EQ(textIn(chinese.get(), rowOf(Tab::Timeline).brief), "时间");
}

INSTANTIATE_TEST_SUITE_P(All, Languages, testing::ValuesIn(languages),
                         [](const auto& each) { return std::string(rowOf(each.param).name); });

} // namespace
} // namespace texplorer::language_window_test
