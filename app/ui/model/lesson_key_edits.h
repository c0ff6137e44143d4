#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

struct Session;
struct LessonRun;

/// Whether a key of the open lesson has an effect in its step.
[[nodiscard]] bool isUsable(const LessonRun& run, std::size_t key);

/// Whether the open lesson uses a key, by its name in lessons, instead of a window's shortcut.
[[nodiscard]] bool isTakenByLesson(const Session& session, std::string_view key);

struct KeyPress {
    std::size_t key = 0; ///< its index
    float times = 1;     ///< how often it adds
};

/// Applies the actions of keys: a choice is one undo step; additions continue the same step until
/// releaseLessonKey.
void pressLessonKeys(const Session& session, std::span<const KeyPress> presses);
void releaseLessonKey(const Session& session);

/// The current effect of a key: the choice in the window's language, or the number.
[[nodiscard]] std::string stateOfKey(const Session& session, const LessonRun& run, std::size_t key);

} // namespace texplorer::ui
