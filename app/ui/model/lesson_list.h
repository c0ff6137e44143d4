#pragma once

#include "app/ui/language/language.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// One of the program's own lessons, as a list shows it.
struct LessonTitle {
    std::string name;
    std::string title;
    std::string about;
    std::size_t steps = 0;
};

/// All of them in a language, in the order in which they are taught. Read once for each language.
[[nodiscard]] const std::vector<LessonTitle>& lessonTitles(Language language);

} // namespace texplorer::ui
