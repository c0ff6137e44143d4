#include "app/ui/language/catalogue.h"

#include <gmock/gmock.h>

namespace texplorer::catalogue_test {
namespace {

using namespace ui;
using testing::HasSubstr;
using testing::Optional;
using testing::StrEq;

constexpr std::string_view header = "# A comment.\nmsgid \"\"\nmsgstr \"\"\n\"Language: ru\\n\"\n\n";

Catalogue read(std::string_view entries, Language language = Language::Russian) {
    const std::string text = std::string(header) + std::string(entries);
    const std::vector<CatalogueFile> files{{"ru/test.po", text}};
    return Catalogue::parse(language, files).value();
}

Error refused(const std::string& text) {
    const std::vector<CatalogueFile> files{{"ru/test.po", text}};
    const Result<Catalogue> catalogue = Catalogue::parse(Language::Russian, files);
    EXPECT_FALSE(catalogue) << text;
    return catalogue ? Error{} : catalogue.error();
}

TEST(Catalogue, FindsAWholeText) {
    const Catalogue catalogue = read("#: a.cpp\nmsgid \"Cancel\"\nmsgstr \"Отмена\"\n");
    EXPECT_THAT(catalogue.translate("Cancel"), Optional(StrEq("Отмена")));
    EXPECT_EQ(catalogue.translate("Cancelled"), std::nullopt);
    EXPECT_EQ(catalogue.translate(""), std::nullopt);
    EXPECT_EQ(catalogue.translate("0.5 × 2"), std::nullopt);
}

TEST(Catalogue, TranslatesASentenceByItsKey) {
    const Catalogue catalogue =
        read("msgid \"at most {0} × {0} of {1}\"\nmsgstr \"для {2}: {0} × {1}\"\n\n"
             "msgid \"{} page\"\nmsgid_plural \"{} pages\"\n"
             "msgstr[0] \"{} лист\"\nmsgstr[1] \"{} листа\"\nmsgstr[2] \"{} листов\"\n\n"
             "msgid \"{} from {}\"\nmsgstr \"{1}: {0}\"\n");
    std::vector<std::string> gaps;
    const auto translated = [&](const Sentence& sentence) {
        return catalogue.translate(
            sentence, [](std::string_view word) { return "<" + std::string(word) + ">"; },
            [&](std::string_view gap) { gaps.emplace_back(gap); });
    };
    EXPECT_EQ(translated(Sentence("at most {0} × {0} of {1}", 8, "DDS")), "для <DDS>: 8 × 8");
    EXPECT_EQ(
        translated(Sentence("{0} from {1}", Sentence("{0} pages", 3), ProperName{"at most 1 × 1 of 2"})),
        "at most 1 × 1 of 2: 3 листа")
        << "a name that looks like a sentence stays";
    EXPECT_EQ(translated("Cancel"), "<Cancel>");
    EXPECT_EQ(translated(Sentence("{0}: {1}", ProperName{"a"}, "b")), "a: <b>");
    EXPECT_THAT(gaps, testing::IsEmpty());
    EXPECT_EQ(translated(Sentence("unknown {0}", 1)), "unknown 1");
    EXPECT_THAT(gaps, testing::ElementsAre("unknown 1"));
}

TEST(Catalogue, ReadsEscapesAndTextsOfSeveralLines) {
    const Catalogue catalogue = read(
        "msgid \"\"\n\"a \\\"b\\\"\\n\"\n\"c\"\nmsgstr \"\"\n\"x \\\\\"\n\"y\"\nmsgid \"d\"\nmsgstr \"z\"");
    EXPECT_THAT(catalogue.translate("a \"b\"\nc"), Optional(StrEq("x \\y")));
    EXPECT_THAT(catalogue.translate("d"), Optional(StrEq("z"))) << "without an empty line between them";
}

TEST(Catalogue, FillsPlacesAndTranslatesWhatStandsThere) {
    const Catalogue catalogue = read("msgid \"{} of {} is off\"\nmsgstr \"у {1} выключен {0}\"\n\n"
                                     "msgid \"the filter\"\nmsgstr \"фильтр\"\n\n"
                                     "msgid \"save {{}}: {:.3g}\"\nmsgstr \"запись {{}}: {}\"\n");
    EXPECT_THAT(catalogue.translate("the filter of unit 2 is off"),
                Optional(StrEq("у unit 2 выключен фильтр")));
    EXPECT_THAT(catalogue.translate("save {}: 1.5"), Optional(StrEq("запись {}: 1.5")));
}

TEST(Catalogue, TakesTheKeyThatSaysMost) {
    const Catalogue catalogue = read("msgid \"expected {}\"\nmsgstr \"A {}\"\n\n"
                                     "msgid \"expected {}, found {}\"\nmsgstr \"B {} {}\"\n");
    EXPECT_THAT(catalogue.translate("expected 1, found 2"), Optional(StrEq("B 1 2")));
    EXPECT_THAT(catalogue.translate("expected 1"), Optional(StrEq("A 1")));
    EXPECT_THAT(catalogue.translate("expected a, b, found c, found d"), Optional(StrEq("B a, b c, found d")))
        << "the first place ends where it can";
}

// With a capital letter a text still matches that key, which is more specific than one that begins with a
// placeholder.
TEST(Catalogue, TakesTheKeyThatSaysMostWithItsCapitalToo) {
    const Catalogue catalogue =
        read("msgid \"{} is incomplete: {}\"\nmsgstr \"A {} {}\"\n\n"
             "msgid \"the texture is incomplete: {} needs {}\"\nmsgstr \"б {} {}\"\n");
    EXPECT_THAT(catalogue.translate("The texture is incomplete: 1 needs 2."), Optional(StrEq("Б 1 2.")));
    EXPECT_THAT(catalogue.translate("textures[0] is incomplete: the texture is incomplete: 1 needs 2"),
                Optional(StrEq("A textures[0] б 1 2")));
}

TEST(Catalogue, TakesTheKeyThatSaysMostWhereItBeginsWithAPlace) {
    const Catalogue catalogue = read("msgid \"{}: the driver has no seams\"\nmsgstr \"{}: A\"\n\n"
                                     "msgid \"the {} has {}\"\nmsgstr \"B {} {}\"\n\n"
                                     "msgid \"Written: {}\"\nmsgstr \"C {}\"\n\n"
                                     "msgid \"Written: {}. {}\"\nmsgstr \"D {} {}\"\n");
    EXPECT_THAT(catalogue.translate("a.json: the driver has no seams"), Optional(StrEq("a.json: A")));
    EXPECT_THAT(catalogue.translate("a.json: the driver has 7"), Optional(StrEq("a.json: B driver 7")));
    EXPECT_THAT(catalogue.translate("Written: 7. 8"), Optional(StrEq("D 7 8"))) << "as many letters";
}

TEST(Catalogue, TakesTheFormOfANumber) {
    const Catalogue catalogue = read("msgid \"{} setting\"\nmsgid_plural \"{} settings\"\n"
                                     "msgstr[0] \"{} настройка\"\nmsgstr[1] \"{} настройки\"\n"
                                     "msgstr[2] \"{} настроек\"\n");
    EXPECT_THAT(catalogue.translate("1 setting"), Optional(StrEq("1 настройка")));
    EXPECT_THAT(catalogue.translate("3 settings"), Optional(StrEq("3 настройки")));
    EXPECT_THAT(catalogue.translate("11 settings"), Optional(StrEq("11 настроек")));
    EXPECT_THAT(catalogue.translate("21 settings"), Optional(StrEq("21 настройка")));
}

TEST(Catalogue, ReadsAPlaceBeforeASentence) {
    const Catalogue catalogue =
        read("msgid \"{} pixels are read\"\nmsgstr \"прочитано {}\"\n\n"
             "msgid \"{} delta\"\nmsgid_plural \"{} deltas\"\n"
             "msgstr[0] \"{} дельта\"\nmsgstr[1] \"{} дельты\"\nmsgstr[2] \"{} дельт\"\n");
    EXPECT_THAT(catalogue.translate("BMP: 8 pixels are read"), Optional(StrEq("BMP: прочитано 8")));
    EXPECT_THAT(catalogue.translate("RLE8: 3 runs, 2 deltas"), Optional(StrEq("RLE8: 3 runs, 2 дельты")))
        << "only a number is counted";
    const Catalogue chinese =
        read("msgid \"{} pixel\"\nmsgid_plural \"{} pixels\"\nmsgstr[0] \"{} 个像素\"\n", Language::Chinese);
    EXPECT_EQ(chinese.translate("enlarge the pixels"), std::nullopt);
}

TEST(Catalogue, FindsASentenceWithItsCapitalAndItsFullStop) {
    const std::string_view entry = "msgid \"the unit is off\"\nmsgstr \"блок выключен\"\n\n"
                                   "msgid \"it is on\"\nmsgstr \"ёмкость\"\n\n"
                                   "msgid \"red\"\nmsgstr \"рамка\"\n";
    EXPECT_THAT(read(entry).translate("The unit is off."), Optional(StrEq("Блок выключен.")));
    EXPECT_THAT(read(entry).translate("Red"), Optional(StrEq("Рамка"))) << "р has another first byte than б";
    EXPECT_THAT(
        read("msgid \"begin and {}\"\nmsgstr \"начать и {}\"\n\nmsgid \"Make them\"\nmsgstr \"Сделать\"\n")
            .translate("begin and make them"),
        Optional(StrEq("начать и сделать")));
    EXPECT_THAT(read(entry, Language::Chinese).translate("the unit is off."),
                Optional(StrEq("блок выключен。")));
}

TEST(Catalogue, TranslatesPartsOneByOneAndReadsAKeyOfSeveralLines) {
    const Catalogue catalogue =
        read("msgid \"{}\\nClick: undo {}\"\nmsgstr \"{}\\nЩелчок: отменить {}\"\n\n"
             "msgid \"Red\"\nmsgstr \"Красный\"\n\nmsgid \"Green\"\nmsgstr \"Зелёный\"\n");
    EXPECT_THAT(catalogue.translate("Red\nClick: undo 3"), Optional(StrEq("Красный\nЩелчок: отменить 3")));
    EXPECT_THAT(catalogue.translate("Red\nGL_RED  ·  Green"), Optional(StrEq("Красный\nGL_RED  ·  Зелёный")));
    EXPECT_THAT(catalogue.translate("a.png: Red"), Optional(StrEq("a.png: Красный")));
    EXPECT_THAT(catalogue.translate("Green: Red"), Optional(StrEq("Зелёный: Красный")));
    EXPECT_THAT(catalogue.translate("Green: Red", {"Green"}), Optional(StrEq("Green: Красный"))) << "a name";
    EXPECT_THAT(catalogue.translate("Red 12"), Optional(StrEq("Красный 12")));
    EXPECT_THAT(catalogue.translate("  Red"), Optional(StrEq("  Красный")));
    EXPECT_THAT(catalogue.translate("Red 25 %, Red"), Optional(StrEq("Red 25 %, Красный")));
    EXPECT_THAT(catalogue.translate("Red. Green."), Optional(StrEq("Красный. Зелёный.")));
    EXPECT_EQ(catalogue.translate("a.png: b"), std::nullopt);
}

TEST(Catalogue, LeavesOutWhatIsNotReady) {
    const Catalogue catalogue =
        read("#, fuzzy\nmsgid \"Red\"\nmsgstr \"Р\"\n\nmsgid \"Green\"\nmsgstr \"\"\n\n"
             "msgid \"Blue\"\nmsgstr \"Синий\"\n");
    EXPECT_EQ(catalogue.translate("Red"), std::nullopt);
    EXPECT_EQ(catalogue.translate("Green"), std::nullopt);
    EXPECT_THAT(catalogue.translate("Blue"), Optional(StrEq("Синий")));
    EXPECT_THAT(catalogue.letters(), StrEq("Синий"));
}

TEST(Catalogue, SaysWhichLineIsWrong) {
    EXPECT_EQ(refused("msgid \"a\"\nmsgstr \"b\"\nnonsense\n").where, "ru/test.po:3");
    EXPECT_EQ(refused("msgstr \"b\"\n").where, "ru/test.po:1");
    EXPECT_EQ(refused("\n\n\"b\"\n").where, "ru/test.po:3");
    EXPECT_EQ(refused("msgid \"a\n").where, "ru/test.po:1");
    EXPECT_EQ(refused("msgid \"a\\\"\n").where, "ru/test.po:1");
}

TEST(Catalogue, RefusesATranslationWithOtherPlaces) {
    for (const char* form : {"нет", "{} {}", "{1}", "{0} {0}", "{"}) {
        const Error error = refused(std::string("\nmsgid \"a place: {}\"\nmsgstr \"") + form + "\"\n");
        EXPECT_THAT(error.message, HasSubstr("expected a translation with 1 places")) << form;
        EXPECT_EQ(error.where, "ru/test.po:2") << form;
    }
}

// A long text is quoted by its beginning; one with more placeholders than any of ours is refused.
TEST(Catalogue, SaysLittleOfALongText) {
    const std::string longText(100'000, 'x');
    const Error error = refused("msgid \"a place: {}\"\nmsgstr \"" + longText + "\"\n");
    EXPECT_THAT(error.message, HasSubstr("found \"xxxxxxxx"));
    EXPECT_LT(error.message.english().size(), 200U);
    std::string places;
    for (int i = 0; i < 100'000; ++i)
        places += " {}";
    EXPECT_THAT(refused("msgid \"many" + places + "\"\nmsgstr \"many" + places + "\"\n").message,
                HasSubstr("at most 32 places, found 100000"));
}

// Texts of files and drivers are looked up, too: the lookup ends soon for any text.
TEST(Catalogue, AnswersForTextsThatAreMadeForItWithoutACrash) {
    const Catalogue catalogue = read("msgid \"{} abc {} abc {} abc {} abc {} end\"\nmsgstr \"{}{}{}{}{}\"\n");
    std::string text;
    for (int i = 0; i < 5000; ++i)
        text += " abc . : \n · ";
    EXPECT_EQ(catalogue.translate(text), std::nullopt);
    EXPECT_EQ(catalogue.translate(std::string(100'000, 'a') + ": "), std::nullopt);
    EXPECT_EQ(catalogue.translate("\xff\xfe abc \xc0"), std::nullopt);
}

// A name from a scene's file, in a tooltip: trying every division would take minutes.
TEST(Catalogue, GivesUpATextThatCanBeDividedInTooManyWays) {
    for (const Language language : {Language::Chinese, Language::Russian}) {
        const auto catalogue = catalogueOf(language).value();
        for (const std::string_view part : {"a: b, c. d · e  ·  f\n", "a: "}) {
            std::string text;
            while (text.size() < 100'000)
                text += part;
            EXPECT_EQ(catalogue->translate(text), std::nullopt);
            EXPECT_EQ(
                catalogue->translate(std::string_view(text).substr(0, 4096 / part.size() * part.size())),
                std::nullopt)
                << part;
        }
        EXPECT_NE(catalogue->translate("Cancel"), std::nullopt) << "the next text has its own time";
    }
}

} // namespace
} // namespace texplorer::catalogue_test
