#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace texplorer::ui {

struct Session;
struct LessonRun;

/// Whether a key of the open lesson does something in its step.
[[nodiscard]] bool isUsable(const LessonRun& run, std::size_t key);

/// Whether the open lesson has taken a key, by the name that a lesson has for it, from the window's
/// shortcuts.
[[nodiscard]] bool isTakenByLesson(const Session& session, std::string_view key);

/// Does what a key says: a choice is a step of undo; what only adds goes on in one until releaseLessonKey.
/// `times`: how often it adds.
void pressLessonKey(Session& session, std::size_t key, float times);
void releaseLessonKey(Session& session);

/// What a key has led to: the choice in the window's language, or the number.
[[nodiscard]] std::string stateOfKey(const Session& session, const LessonRun& run, std::size_t key);

} // namespace texplorer::ui
