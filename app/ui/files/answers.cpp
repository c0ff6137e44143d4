#include "app/ui/files/answers.h"

#include "app/ui/services/free_name.h"
#include "texplorer/files/file_io.h"
#include "texplorer/lesson/lesson_files.h"

#include <nlohmann/json.hpp>

#include <utility>

namespace texplorer::ui {

std::string answersText(const Settings& settings) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const auto& [key, records] : settings.lessons) {
        const Result<lesson::Lesson> lesson = lesson::LessonFolder::builtIn(key).and_then(
            [](const auto& folder) { return readLesson(folder); });
        Json steps = Json::array();
        for (std::size_t i = 0; i < records.size(); ++i) {
            Json step{{"step", i + 1}, {"done", records[i].done}};
            if (records[i].tries > 0)
                step["tries"] = records[i].tries;
            if (lesson && i < lesson->steps.size())
                step["title"] = lesson->steps[i].title;
            steps.push_back(std::move(step));
        }
        Json one{{"lesson", lesson ? key : std::filesystem::path(key).filename().string()}};
        if (!lesson)
            one["folder"] = key;
        one["steps"] = std::move(steps);
        list.push_back(std::move(one));
    }
    return Json{{"answers", std::move(list)}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<std::filesystem::path> saveAnswers(const Settings& settings, const std::filesystem::path& file,
                                          const std::optional<FileFingerprint>& replaces) {
    return writeFreely(file, viewBytes(answersText(settings)), replaces);
}

} // namespace texplorer::ui
