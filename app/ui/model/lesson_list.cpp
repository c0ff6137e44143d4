#include "app/ui/model/lesson_list.h"

#include "app/ui/language/lesson_catalogue.h"
#include "texplorer/lesson/lesson_files.h"

#include <array>
#include <memory>
#include <optional>

namespace texplorer::ui {
namespace {

std::vector<LessonTitle> readTitles(Language language) {
    std::vector<LessonTitle> titles;
    for (const std::string& name : lesson::builtInLessons()) {
        const Result<lesson::LessonFolder> folder = lesson::LessonFolder::builtIn(name);
        const Result<lesson::Lesson> found =
            folder ? readLesson(*folder) : Result<lesson::Lesson>(fail(folder.error()));
        if (!found)
            continue; // a test reads all of them
        const std::shared_ptr<const Catalogue> catalogue = catalogueOfLesson(*folder, language);
        titles.push_back({name, textIn(catalogue.get(), found->title), textIn(catalogue.get(), found->about),
                          found->steps.size()});
    }
    return titles;
}

} // namespace

const std::vector<LessonTitle>& lessonTitles(Language language) {
    static std::array<std::optional<std::vector<LessonTitle>>, languageRows.size()> known; // constants
    std::optional<std::vector<LessonTitle>>& titles = known.at(static_cast<std::size_t>(language));
    if (!titles)
        titles = readTitles(language);
    return *titles;
}

} // namespace texplorer::ui
