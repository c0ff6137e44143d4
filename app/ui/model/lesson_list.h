#pragma once

#include "app/ui/language/language.h"

#include <string>
#include <vector>

namespace texplorer::ui {

/// A built-in lesson in a list.
struct LessonTitle {
    std::string name;
    std::string title;
    std::string about;
    std::size_t steps = 0;
};

/// All built-in lessons in a language, in teaching order. Read once for each language.
[[nodiscard]] const std::vector<LessonTitle>& lessonTitles(Language language);

} // namespace texplorer::ui
