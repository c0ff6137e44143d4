#include "app/ui/language/language.h"

#include <algorithm>
#include <cstdlib>

namespace texplorer::ui {

const LanguageRow& rowOf(Language language) {
    return *std::ranges::find(languageRows, language, &LanguageRow::language);
}

std::string catalogueFileOf(Language language) {
    return std::string(rowOf(language).name) + ".po";
}

Language languageOfLocale(std::string_view locale) {
    const std::string_view language = locale.substr(0, locale.find_first_of("_.-@:"));
    const auto isOfIt = [language](const LanguageRow& row) {
        return row.language != Language::System && row.name.substr(0, row.name.find('_')) == language;
    };
    const auto row = std::ranges::find_if(languageRows, isOfIt);
    return row == languageRows.end() ? Language::English : row->language;
}

Language languageOfEnvironment(const std::function<const char*(const char* name)>& variable) {
    std::string_view locale;
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        if (const char* value = variable(name); value && *value && locale.empty())
            locale = value;
    }
    if (locale.empty() || locale == "C" || locale == "POSIX")
        return Language::English;
    const char* list = variable("LANGUAGE");
    return languageOfLocale(list && *list ? std::string_view(list) : locale);
}

Language languageOfSystem() {
    return languageOfEnvironment([](const char* name) {
        return std::getenv(name);
    }); // NOLINT(concurrency-mt-unsafe): no thread changes it
}

} // namespace texplorer::ui
