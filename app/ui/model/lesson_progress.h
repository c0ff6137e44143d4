#pragma once

// The results of lesson steps in Settings::lessons, which are kept after a lesson is closed.

#include "app/ui/model/settings.h"
#include "core/base/result.h"
#include "core/files/file_fingerprint.h"
#include "core/lesson/lesson_files.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace texplorer::ui {

struct Session;

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
[[nodiscard]] LessonProgress progressOf(const Session& session, const std::string& key, std::size_t steps);
[[nodiscard]] bool isStepDone(const Session& session, const std::string& key, std::size_t step);

/// The student's answers in all lessons, as JSON, to keep or hand in.
[[nodiscard]] std::string answersText(const Session& session);

/// The same as a file, written by writeFreely.
[[nodiscard]] Result<std::filesystem::path> saveAnswers(const Session& session,
                                                        const std::filesystem::path& file,
                                                        const std::optional<FileFingerprint>& replaces = {});

} // namespace texplorer::ui
