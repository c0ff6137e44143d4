#include "app/ui/model/lesson_progress.h"

#include "app/ui/model/free_name.h"
#include "app/ui/model/session.h"
#include "core/files/file_io.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace texplorer::ui {
namespace {

bool isBuiltIn(const std::string& key) {
    return lesson::LessonFolder::builtIn(key).has_value();
}

/// Makes room for one more: removes first folders that no longer exist, then any.
void makeRoomForLesson(std::map<std::string, std::vector<StepRecord>>& lessons) {
    const auto isGone = [](const auto& each) {
        std::error_code ignored;
        return !isBuiltIn(each.first) && !std::filesystem::is_directory(each.first, ignored);
    };
    while (lessons.size() >= maxLessonsKept) {
        auto found = std::ranges::find_if(lessons, isGone);
        if (found == lessons.end())
            found = std::ranges::find_if(lessons, [](const auto& each) { return !isBuiltIn(each.first); });
        lessons.erase(found == lessons.end() ? lessons.begin() : found);
    }
}

} // namespace

std::string progressKey(const lesson::LessonFolder& folder) {
    if (folder.path().empty())
        return folder.name();
    std::error_code failed;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(folder.path(), failed);
    return (failed ? folder.path() : whole.has_filename() ? whole : whole.parent_path()).generic_string();
}

void takeOldRecords(Settings& settings, const lesson::LessonFolder& folder, const std::string& key) {
    if (folder.path().empty() || settings.lessons.contains(key) || isBuiltIn(folder.name()))
        return;
    if (auto old = settings.lessons.extract(folder.name())) {
        old.key() = key;
        settings.lessons.insert(std::move(old));
    }
}

StepRecord& recordOf(Settings& settings, const std::string& key, std::size_t steps, std::size_t step) {
    if (!settings.lessons.contains(key))
        makeRoomForLesson(settings.lessons);
    std::vector<StepRecord>& records = settings.lessons[key];
    records.resize(std::max(records.size(), steps));
    return records[step];
}

bool isStepDone(const Session& session, const std::string& key, std::size_t step) {
    const auto found = session.window.settings.lessons.find(key);
    return found != session.window.settings.lessons.end() && step < found->second.size() &&
           found->second[step].done;
}

LessonProgress progressOf(const Session& session, const std::string& key, std::size_t steps) {
    LessonProgress progress{0, steps};
    for (std::size_t i = 0; i < steps; ++i)
        progress.done += isStepDone(session, key, i) ? 1U : 0U;
    return progress;
}

std::string answersText(const Session& session) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const auto& [key, records] : session.window.settings.lessons) {
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

Result<std::filesystem::path> saveAnswers(const Session& session, const std::filesystem::path& file,
                                          const std::optional<FileFingerprint>& replaces) {
    return writeFreely(file, viewBytes(answersText(session)), replaces);
}

} // namespace texplorer::ui
