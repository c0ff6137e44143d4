#pragma once

namespace texplorer {

/// Marks a text that users read, so that `./dev translate` finds it, as gettext's N_ does. Texts in calls
/// that translate or that take a Sentence need no mark: their names are in assets/translations/extract.sh.
[[nodiscard]] constexpr const char*
N_(const char* english) { // NOLINT(readability-identifier-naming): as in gettext
    return english;
}

} // namespace texplorer
