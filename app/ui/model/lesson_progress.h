#pragma once

// What was done in which step of which lesson: Settings::lessons, which outlives the lesson that is open.

#include "app/ui/model/settings.h"
#include "core/base/file_fingerprint.h"
#include "core/base/result.h"
#include "core/lesson/lesson_files.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session;

/// Under which name it is kept: the program's own lessons by theirs, a folder by where it is, so that two of
/// the same name are two.
[[nodiscard]] std::string progressKey(const lesson::LessonFolder& folder);

/// Settings of before kept a folder's steps by its name alone: they become those of `key`.
void takeOldRecords(Settings& settings, const lesson::LessonFolder& folder, const std::string& key);

/// Of a step of a lesson that has so many. Where too many lessons are kept, one gives way.
[[nodiscard]] StepRecord& recordOf(Settings& settings, const std::string& key, std::size_t steps,
                                   std::size_t step);

/// How many of the steps were done.
struct LessonProgress {
    std::size_t done = 0;
    std::size_t steps = 0;
};
[[nodiscard]] LessonProgress progressOf(const Session& session, const std::string& key, std::size_t steps);
[[nodiscard]] bool isStepDone(const Session& session, const std::string& key, std::size_t step);

/// What the student answered in which lesson, as JSON, to be kept or handed in.
[[nodiscard]] std::string answersText(const Session& session);

/// The same as a file, by writeFreely.
[[nodiscard]] Result<std::filesystem::path> saveAnswers(const Session& session,
                                                        const std::filesystem::path& file,
                                                        const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
