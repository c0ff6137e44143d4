#include "app/ui/language/translate.h"

#include <gmock/gmock.h>

namespace texplorer::translate_test {
namespace {

using namespace ui;
using testing::ElementsAre;

class Translate : public testing::Test {
protected:
    void SetUp() override { useCatalogue(&catalogue, &gaps); }
    void TearDown() override { useCatalogue(nullptr); }

    static Catalogue read(const char* entries) {
        return Catalogue::parse(Language::Chinese, std::vector<CatalogueFile>{{"zh_CN/a.po", entries}})
            .value();
    }

    std::set<std::string, std::less<>> gaps;
    Catalogue catalogue = read("msgid \"Cancel\"\nmsgstr \"取消\"\n");
};

TEST_F(Translate, LeavesEnglishAlone) {
    useCatalogue(nullptr);
    const char* text = "Cancel";
    EXPECT_EQ(tr(text), text);
    EXPECT_EQ(label(text), text);
    EXPECT_EQ(tr(std::string("Cancel##3")), "Cancel##3");
}

TEST_F(Translate, GroupsDigitsAsTheLanguageDoes) {
    useCatalogue(nullptr);
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1398100), "1,398,100");
    EXPECT_EQ(bytesText(1).english(), "1 byte");
    EXPECT_EQ(bytesText(12345).english(), "12,345 bytes");
    const Catalogue russian =
        Catalogue::parse(
            Language::Russian,
            std::vector<CatalogueFile>{{"ru/a.po", "msgid \"{0} byte\"\nmsgid_plural \"{0} bytes\"\n"
                                                   "msgstr[0] \"{0} байт\"\nmsgstr[1] \"{0} байта\"\n"
                                                   "msgstr[2] \"{0} байт\"\n"}})
            .value();
    useCatalogue(&russian);
    EXPECT_EQ(grouped(1398100), "1\u00A0398\u00A0100");
    EXPECT_EQ(tr(bytesText(12342)), "12\u00A0342 байта");
}

TEST_F(Translate, RemembersWhatIsMissing) {
    EXPECT_STREQ(tr("Cancel"), "取消");
    EXPECT_STREQ(tr("Nothing"), "Nothing");
    EXPECT_EQ(tr(std::string_view("Nothing")), "Nothing");
    EXPECT_THAT(gaps, ElementsAre("Nothing"));
}

TEST_F(Translate, KeepsTheIdentityOfALabel) {
    EXPECT_STREQ(label("Cancel"), "取消###Cancel");
    EXPECT_EQ(label(std::string("Cancel##3")), "取消###Cancel##3");
    EXPECT_EQ(label(std::string("Cancel###id")), "取消###id");
    EXPECT_STREQ(label("##only an identity"), "##only an identity");
    EXPECT_STREQ(label(""), "");
}

// "Texture" as a name of a file or a model.
TEST_F(Translate, KeepsNamesInSentences) {
    const Catalogue sentences =
        read("msgid \"Texture\"\nmsgstr \"纹理\"\n\nmsgid \"Open {0}\"\nmsgstr \"打开 {0}\"\n");
    useCatalogue(&sentences);
    EXPECT_EQ(tr(Sentence("Open {0}", "Texture")), "打开 纹理");
    EXPECT_EQ(tr(Sentence("Open {0}", ProperName{"Texture"})), "打开 Texture");
    EXPECT_EQ(tr(Sentence(ProperName{"Texture"})), "Texture");
}

TEST_F(Translate, ForgetsWithTheCatalogue) {
    EXPECT_STREQ(tr("Cancel"), "取消");
    useCatalogue(nullptr);
    EXPECT_STREQ(tr("Cancel"), "Cancel");
    EXPECT_EQ(catalogueInUse(), nullptr);
}

} // namespace
} // namespace texplorer::translate_test
