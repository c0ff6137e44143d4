#include "app/ui/language/catalogue.h"
#include "app/ui/language/po_file.h"

#include <gmock/gmock.h>

#include <array>
#include <string>
#include <vector>

namespace texplorer::catalogue_test {
namespace {

using namespace ui;
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
        EXPECT_THAT(error.message, testing::StartsWith("expected a translation with")) << form;
        EXPECT_EQ(error.where, "ru/test.po: line 2") << form;
    }
    EXPECT_EQ(refused("msgid \"a place: {0}\"\nmsgstr \"нет\"\n").message,
              "expected a translation with {0}, as in its text");
    EXPECT_EQ(refused("msgid \"a place: {0}\"\nmsgstr \"{0} {1}\"\n").message,
              "expected a translation without {1}, as in its text");
    const Error error = refused("msgid \"a place\"\nmsgstr \"{" + std::string(100'000, 'x') + "}\"\n");
    EXPECT_LT(error.message.english().size(), 200U);
}

TEST(Catalogue, SaysWhichLineIsWrong) {
    EXPECT_EQ(refused("msgid \"a\"\nmsgstr \"b\"\nnonsense\n").where, "ru/test.po: line 3");
    EXPECT_EQ(refused("msgstr \"b\"\n").where, "ru/test.po: line 1");
    EXPECT_EQ(refused("\n\n\"b\"\n").where, "ru/test.po: line 3");
    EXPECT_EQ(refused("msgid \"a\n").where, "ru/test.po: line 1");
    EXPECT_EQ(refused("msgid \"a\\\"\n").where, "ru/test.po: line 1");
}

std::size_t countOf(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/// Every text of the program, in each language and plural form: an argument is inserted wherever the form has
/// its placeholder, as it is, and nowhere else.
TEST(Catalogues, InsertUnusualArgumentsIntoEveryForm) {
    const std::array<std::string, 8> names{
        "<0>{1}",   "<1>}{", "<2>\xFF\xFE", "<3>##%s\n\\", "<4>" + std::string(5000, 'x'),
        "<5>{{0}}", "<6>",   "<7>\x1B["};
    const auto named = [&](std::size_t i) { return ProperName{names.at(i)}; };
    const Sentence sentence("{0}{1}{2}{3}{4}{5}{6}{7}", named(0), named(1), named(2), named(3), named(4),
                            named(5), named(6), named(7));
    std::size_t forms = 0;
    for (const CatalogueFile& file : catalogueFiles()) {
        const Result<std::vector<PoEntry>> entries = readPoFile(file.text, file.name);
        ASSERT_TRUE(entries) << describe(entries.error());
        for (const PoEntry& entry : *entries) {
            for (const std::string& form : entry.forms) {
                const std::string text =
                    sentence.in(form, [](const Sentence& each) { return each.english(); });
                std::size_t inserted = 0;
                for (std::size_t i = 0; i < names.size(); ++i) {
                    const std::string place = "{" + std::to_string(i);
                    const std::size_t places = countOf(form, place + "}") + countOf(form, place + ":");
                    EXPECT_EQ(countOf(text, names.at(i)), places) << file.name << ": " << form;
                    EXPECT_EQ(places > 0, entry.key.find(place) != std::string::npos)
                        << file.name << ": " << form;
                    inserted += places * names.at(i).size();
                }
                EXPECT_LE(inserted, text.size());
                EXPECT_LE(text.size() - inserted, form.size()) << file.name << ": " << form;
                ++forms;
            }
        }
    }
    EXPECT_GT(forms, 7'000U);
}

} // namespace
} // namespace texplorer::catalogue_test
