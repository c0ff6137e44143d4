#pragma once

// The results of lesson steps in Settings::lessons, which are kept after a lesson is closed.

#include "app/ui/state/settings.h"
#include "texplorer/lesson/lesson_files.h"

#include <cstddef>
#include <string>

namespace texplorer::ui {

/// The key of a lesson's records: the name of a built-in lesson, the path of a folder, so that two folders
/// with the same name differ.
[[nodiscard]] std::string progressKey(const lesson::LessonFolder& folder);

/// Old settings stored a folder's steps by its name alone: moves them to `key`.
void takeOldRecords(Settings& settings, const lesson::LessonFolder& folder, const std::string& key);

/// The record of a step in a lesson with this number of steps. If too many lessons are kept, one of them is
/// replaced.
[[nodiscard]] StepRecord& recordOf(Settings& settings, const std::string& key, std::size_t steps,
                                   std::size_t step);

/// The number of steps that are done.
struct LessonProgress {
    std::size_t done = 0;
    std::size_t steps = 0;
};
[[nodiscard]] LessonProgress progressOf(const Settings& settings, const std::string& key, std::size_t steps);
[[nodiscard]] bool isStepDone(const Settings& settings, const std::string& key, std::size_t step);

} // namespace texplorer::ui
