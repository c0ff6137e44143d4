#pragma once

#include "texplorer/base/translatable.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace texplorer::ui {

enum class Language { System, English, Chinese, Russian };

struct LanguageRow {
    Language language;
    std::string_view name; ///< its catalogue without ".po"; its name in the settings file and for --language
    const char* label;     ///< in letters of the default font
    /// The index of gettext's plural form for a number.
    std::size_t (*form)(std::uint64_t number);
    std::string_view thousands = ","; ///< what separates groups of three digits
};

namespace plural {
constexpr std::size_t one(std::uint64_t) {
    return 0;
}
constexpr std::size_t oneAndMore(std::uint64_t number) {
    return number == 1 ? 0 : 1;
}
/// 1, 21, 31 …; 2 to 4, 22 to 24 …; the others.
constexpr std::size_t slavic(std::uint64_t number) {
    const std::uint64_t last = number % 10;
    const bool isTeen = number % 100 >= 11 && number % 100 <= 14;
    if (last == 1 && !isTeen)
        return 0;
    return last >= 2 && last <= 4 && !isTeen ? 1 : 2;
}
} // namespace plural

inline constexpr std::array languageRows{
    LanguageRow{Language::System, "system", N_("Like the system"), plural::oneAndMore},
    LanguageRow{Language::English, "en", N_("English"), plural::oneAndMore},
    LanguageRow{Language::Chinese, "zh_CN", N_("Chinese (Zhongwen)"), plural::one},
    LanguageRow{Language::Russian, "ru", N_("Русский (Russian)"), plural::slavic, "\u00A0"},
};

[[nodiscard]] const LanguageRow& rowOf(Language language);

/// The name of a catalogue's file, in the folder of a lesson, too: "zh_CN.po".
[[nodiscard]] std::string catalogueFileOf(Language language);

/// The language of a locale's name, "zh_CN.UTF-8", "ru" or "zh-Hans"; English where it is another one or
/// none.
[[nodiscard]] Language languageOfLocale(std::string_view locale);

/// The language set in the environment: LC_ALL, LC_MESSAGES or LANG, the first that is set; and unless that
/// is "C", the first language of the list LANGUAGE, as in gettext.
[[nodiscard]] Language languageOfEnvironment(const std::function<const char*(const char* name)>& variable);

/// The language of this process's environment.
[[nodiscard]] Language languageOfSystem();

} // namespace texplorer::ui
