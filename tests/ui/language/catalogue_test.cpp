#include "app/ui/language/catalogue.h"

#include <gmock/gmock.h>

namespace texplorer::catalogue_test {
namespace {

using namespace ui;
using testing::HasSubstr;
using testing::Pointee;
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
    EXPECT_THAT(catalogue.find("Cancel"), Pointee(StrEq("Отмена")));
    for (const char* text : {"Cancelled", "cancel", "", "Cancel."}) {
        EXPECT_EQ(catalogue.find(text), nullptr);
        EXPECT_EQ(textIn(&catalogue, text), text);
    }
    EXPECT_EQ(textIn(nullptr, "Cancel"), "Cancel");
}

TEST(Catalogue, TranslatesASentenceByItsKey) {
    const Catalogue catalogue = read("msgid \"at most {0} × {0} of {1}\"\nmsgstr \"для {1}: {0} × {0}\"\n\n"
                                     "msgid \"{0} from {1:.2f}\"\nmsgstr \"{1}: {0}\"\n\n"
                                     "msgid \"the filter\"\nmsgstr \"фильтр\"\n");
    std::vector<std::string> gaps;
    const auto translated = [&](const Sentence& sentence) {
        return catalogue.translate(sentence, [&](std::string_view gap) { gaps.emplace_back(gap); });
    };
    EXPECT_EQ(translated(Sentence("at most {0} × {0} of {1}", 8, "the filter")), "для фильтр: 8 × 8");
    EXPECT_EQ(translated(Sentence("{0} from {1:.2f}", Sentence("at most {0} × {0} of {1}", 3, "DDS"), 0.125)),
              "0.12: для DDS: 3 × 3");
    EXPECT_EQ(translated("the filter"), "фильтр");
    EXPECT_EQ(translated(ProperName{"the filter"}), "the filter");
    EXPECT_THAT(gaps, testing::IsEmpty());
    EXPECT_EQ(translated(Sentence("unknown {0}", "the filter")), "unknown фильтр");
    EXPECT_THAT(gaps, testing::ElementsAre("unknown the filter"));
}

TEST(Catalogue, KeepsArgumentsThatLookLikeSentences) {
    const Catalogue catalogue = read("msgid \"{0}: {1}\"\nmsgstr \"{0} – {1}\"\n\n"
                                     "msgid \"Texture\"\nmsgstr \"Текстура\"\n");
    for (const char* name : {"Texture", "{0}: {1}", "{1}", "}{", "", "a: Texture\n", "\xff\xfe"}) {
        EXPECT_EQ(catalogue.translate(Sentence("{0}: {1}", ProperName{name}, -7)),
                  std::string(name) + " – -7");
    }
    EXPECT_EQ(catalogue.translate(Sentence("{0}: {1}", "{1}", "Texture")), "{1} – Текстура");
    const std::string longText(1'000'000, ':');
    EXPECT_EQ(catalogue.translate(Sentence("{0}: {1}", longText, "")).size(), longText.size() + 5);
}

TEST(Catalogue, KeepsDoubledBraces) {
    const Catalogue catalogue = read("msgid \"save {{}}: {0}\"\nmsgstr \"запись {{}}: {0}\"\n");
    EXPECT_EQ(catalogue.translate(Sentence("save {{}}: {0}", 1)), "запись {}: 1");
}

TEST(Catalogue, ReadsEscapesAndTextsOfSeveralLines) {
    const Catalogue catalogue = read(
        "msgid \"\"\n\"a \\\"b\\\"\\n\"\n\"c\"\nmsgstr \"\"\n\"x \\\\\"\n\"y\"\nmsgid \"d\"\nmsgstr \"z\"");
    EXPECT_EQ(textIn(&catalogue, "a \"b\"\nc"), "x \\y");
    EXPECT_EQ(textIn(&catalogue, "d"), "z") << "without an empty line between them";
}

TEST(Catalogue, TakesTheFormOfANumber) {
    constexpr std::string_view entry = "msgid \"{0} setting\"\nmsgid_plural \"{0} settings\"\n"
                                       "msgstr[0] \"{0} настройка\"\nmsgstr[1] \"{0} настройки\"\n"
                                       "msgstr[2] \"{0} настроек\"\n";
    const Catalogue catalogue = read(entry);
    const auto settings = [&](int count) {
        return catalogue.translate(Sentence::plural("{0} setting", "{0} settings", count));
    };
    for (const int count : {1, 21, 101})
        EXPECT_EQ(settings(count), std::to_string(count) + " настройка");
    for (const int count : {2, 4, 22})
        EXPECT_EQ(settings(count), std::to_string(count) + " настройки");
    for (const int count : {0, 5, 11, 12, 111})
        EXPECT_EQ(settings(count), std::to_string(count) + " настроек");
    const Catalogue chinese = read(
        "msgid \"{0} pixel\"\nmsgid_plural \"{0} pixels\"\nmsgstr[0] \"{0} 个像素\"\n", Language::Chinese);
    EXPECT_EQ(chinese.translate(Sentence::plural("{0} pixel", "{0} pixels", 1)), "1 个像素");
    EXPECT_EQ(chinese.translate(Sentence::plural("{0} pixel", "{0} pixels", 2)), "2 个像素");
}

TEST(Catalogue, LeavesOutWhatIsNotReady) {
    const Catalogue catalogue =
        read("#, fuzzy\nmsgid \"Red\"\nmsgstr \"Р\"\n\nmsgid \"Green\"\nmsgstr \"\"\n\n"
             "msgid \"Blue\"\nmsgstr \"Синий\"\n");
    EXPECT_THAT(catalogue.keys(), testing::ElementsAre("Blue"));
    EXPECT_THAT(catalogue.letters(), StrEq("Синий"));
}

TEST(Catalogue, RefusesATranslationWithOtherPlaceholders) {
    for (const char* form : {"нет", "{0} {1}", "{1}", "{}", "{", "{{0}}", "{color}"}) {
        const Error error = refused(std::string("\nmsgid \"a place: {0}\"\nmsgstr \"") + form + "\"\n");
        EXPECT_THAT(error.message,
                    HasSubstr("expected a translation with the placeholders of \"a place: {0}\""))
            << form;
        EXPECT_EQ(error.where, "ru/test.po:2") << form;
    }
    const Error error = refused("msgid \"a place: {0}\"\nmsgstr \"" + std::string(100'000, 'x') + "\"\n");
    EXPECT_LT(error.message.english().size(), 200U);
}

TEST(Catalogue, SaysWhichLineIsWrong) {
    EXPECT_EQ(refused("msgid \"a\"\nmsgstr \"b\"\nnonsense\n").where, "ru/test.po:3");
    EXPECT_EQ(refused("msgstr \"b\"\n").where, "ru/test.po:1");
    EXPECT_EQ(refused("\n\n\"b\"\n").where, "ru/test.po:3");
    EXPECT_EQ(refused("msgid \"a\n").where, "ru/test.po:1");
    EXPECT_EQ(refused("msgid \"a\\\"\n").where, "ru/test.po:1");
}

} // namespace
} // namespace texplorer::catalogue_test
