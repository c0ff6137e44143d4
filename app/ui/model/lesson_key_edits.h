#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer::ui {

struct Session;
struct LessonRun;

/// Whether a key of the open lesson has an effect in its step.
[[nodiscard]] bool isUsable(const LessonRun& run, std::size_t key);

/// Whether the open lesson uses a key, by its name in lessons, instead of a window's shortcut.
[[nodiscard]] bool isTakenByLesson(const Session& session, std::string_view key);

/// Applies a key's action: a choice is one undo step; an addition continues the same step until
/// releaseLessonKey. `times`: how often it adds.
void pressLessonKey(Session& session, std::size_t key, float times);
void releaseLessonKey(Session& session);

/// The current effect of a key: the choice in the window's language, or the number.
[[nodiscard]] std::string stateOfKey(const Session& session, const LessonRun& run, std::size_t key);

} // namespace texplorer::ui
