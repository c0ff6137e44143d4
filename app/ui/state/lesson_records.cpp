#include "app/ui/state/lesson_records.h"

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

bool isStepDone(const Settings& settings, const std::string& key, std::size_t step) {
    const auto found = settings.lessons.find(key);
    return found != settings.lessons.end() && step < found->second.size() && found->second[step].done;
}

LessonProgress progressOf(const Settings& settings, const std::string& key, std::size_t steps) {
    LessonProgress progress{0, steps};
    for (std::size_t i = 0; i < steps; ++i)
        progress.done += isStepDone(settings, key, i) ? 1U : 0U;
    return progress;
}

} // namespace texplorer::ui
