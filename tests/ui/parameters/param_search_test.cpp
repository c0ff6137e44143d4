// The search of the parameters panel: parameters_panel.cpp.

#include "app/ui/model/param_match.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/keys.h"
#include "tests/ui/workbench.h"

namespace texplorer::ui::param_search_test {
namespace {

using namespace test;

const ParamRow& rowOf(const StructTable& table, std::string_view key) {
    return *findParam(table, key);
}

TEST(ParamSearch, FindsByLabelNameCallChoiceAndHelp) {
    const ParamRow& filter = rowOf(textureTable(), "minFilter");
    EXPECT_EQ(matchOf(filter, "minif"), 2);
    EXPECT_EQ(matchOf(filter, "GL_TEXTURE_MIN"), 2);
    EXPECT_EQ(matchOf(filter, "gl_texture_min"), 2) << "in any case";
    EXPECT_EQ(matchOf(filter, "trilinear"), 1);
    EXPECT_EQ(matchOf(filter, "seen from afar"), 1);
    EXPECT_EQ(matchOf(filter, "wrap"), 0);
    EXPECT_EQ(matchOf(filter, "mini texture"), 2) << "each of the words";
    EXPECT_EQ(matchOf(filter, "mini anisotropy"), 0);
    EXPECT_EQ(matchOf(filter, ""), 0);
    EXPECT_EQ(matchOf(filter, "   "), 0);
    EXPECT_EQ(matchOf(rowOf(textureTable(), "maxAnisotropy"), "aniso"), 2);
    EXPECT_EQ(matchOf(rowOf(modelTable(), "texCoords0"), "coord"), 0) << "it has no row";
}

TEST(ParamSearch, FindsInTheWindowsLanguageToo) {
    const std::vector<CatalogueFile> files{
        {"ru/test.po", "msgid \"\"\nmsgstr \"\"\n\nmsgid \"Minification\"\nmsgstr \"Сжатие РЁВ\"\n"}};
    const Result<Catalogue> catalogue = Catalogue::parse(Language::Russian, files);
    ASSERT_TRUE(catalogue);
    useCatalogue(&*catalogue);
    const ParamRow& filter = rowOf(textureTable(), "minFilter");
    EXPECT_EQ(matchOf(filter, "сжатие"), 2);
    EXPECT_EQ(matchOf(filter, "СЖАТ рёв"), 2) << "in any case";
    EXPECT_EQ(matchOf(filter, "minif"), 2) << "English words are still good";
    EXPECT_EQ(matchOf(filter, "рост"), 0);
    useCatalogue(nullptr);
    EXPECT_EQ(matchOf(filter, "сжатие"), 0);
}

class SearchField : public Workbench {
protected:
    void look(std::string_view words) {
        key('F', {ctrl});
        type(words);
    }
};

TEST_F(SearchField, ShowsRowsOfAllTabsWhichOneUsesRightThere) {
    look("aniso");
    EXPECT_EQ(states.parameters.search, "aniso");
    EXPECT_TRUE(has("found in:Texture"));
    drag(place("textures[0].maxAnisotropy"), {100, 0});
    EXPECT_NEAR(texture().maxAnisotropy, 6, 0.2F);
    click("search");
    key(key::escape);
    EXPECT_EQ(states.parameters.search, "");
    EXPECT_TRUE(has("next vertex")) << "Essentials are back";
}

TEST_F(SearchField, FindsByOpenGlsNames) {
    look("GL_TEXTURE_WRAP");
    EXPECT_TRUE(has("found:3"));
    click("textures[0].wrapS=GL_CLAMP");
    EXPECT_EQ(texture().wrapS, Wrap::Clamp);
    click("clear search");
    look("GL_FOG");
    EXPECT_TRUE(has("found in:Pass"));
    EXPECT_TRUE(has("passes[0].fog.density")) << "fog is off, but it is found";
}

TEST_F(SearchField, SaysWhereThereIsNothing) {
    look("zebra");
    EXPECT_TRUE(has("found:0"));
    click("parameters:Light");
    EXPECT_EQ(states.parameters.search, "") << "a tab ends the search";
    EXPECT_TRUE(has("light.position[0]"));
}

} // namespace
} // namespace texplorer::ui::param_search_test
