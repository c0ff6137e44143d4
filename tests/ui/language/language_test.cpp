#include "app/ui/language/language.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace texplorer::language_test {
namespace {

using namespace ui;

TEST(LanguageOfLocale, IsThatOfItsFirstLetters) {
    EXPECT_EQ(languageOfLocale("zh_CN.UTF-8"), Language::Chinese);
    EXPECT_EQ(languageOfLocale("zh-Hans"), Language::Chinese);
    EXPECT_EQ(languageOfLocale("ru"), Language::Russian);
    EXPECT_EQ(languageOfLocale("ru_RU.KOI8-R@x"), Language::Russian);
    EXPECT_EQ(languageOfLocale("rue_UA"), Language::English) << "Rusyn is another language";
    EXPECT_EQ(languageOfLocale("de_DE.UTF-8"), Language::English);
    EXPECT_EQ(languageOfLocale("system"), Language::English);
    EXPECT_EQ(languageOfLocale(""), Language::English);
}

TEST(LanguageOfEnvironment, FollowsGettextsOrder) {
    using Variables = std::map<std::string, const char*>;
    const auto of = [](const Variables& variables) {
        return languageOfEnvironment([&variables](const char* name) {
            const auto found = variables.find(name);
            return found == variables.end() ? nullptr : found->second;
        });
    };
    EXPECT_EQ(of({}), Language::English);
    EXPECT_EQ(of({{"LANG", "ru_RU.UTF-8"}}), Language::Russian);
    EXPECT_EQ(of({{"LANG", "ru_RU.UTF-8"}, {"LC_MESSAGES", "zh_CN.UTF-8"}}), Language::Chinese);
    EXPECT_EQ(of({{"LANG", "ru_RU.UTF-8"}, {"LC_ALL", "en_US.UTF-8"}}), Language::English);
    EXPECT_EQ(of({{"LANG", "ru_RU.UTF-8"}, {"LC_ALL", ""}}), Language::Russian) << "empty is not set";
    EXPECT_EQ(of({{"LANG", "en_US.UTF-8"}, {"LANGUAGE", "zh_CN:ru"}}), Language::Chinese);
    EXPECT_EQ(of({{"LC_ALL", "C"}, {"LANGUAGE", "ru"}}), Language::English) << "C speaks no language";
}

TEST(Plural, TakesTheFormOfEachNumber) {
    const auto form = [](Language language, std::uint64_t number) { return rowOf(language).form(number); };
    for (const auto& [number, russian] :
         {std::tuple(0UL, 2U), std::tuple(1UL, 0U), std::tuple(2UL, 1U), std::tuple(4UL, 1U),
          std::tuple(5UL, 2U), std::tuple(11UL, 2U), std::tuple(12UL, 2U), std::tuple(14UL, 2U),
          std::tuple(21UL, 0U), std::tuple(22UL, 1U), std::tuple(111UL, 2U), std::tuple(121UL, 0U)})
        EXPECT_EQ(form(Language::Russian, number), russian) << number;
    EXPECT_EQ(form(Language::Chinese, 7), 0U);
    EXPECT_EQ(form(Language::English, 1), 0U);
    EXPECT_EQ(form(Language::English, 0), 1U);
}

} // namespace
} // namespace texplorer::language_test
