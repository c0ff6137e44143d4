#pragma once

#include <string>
#include <string_view>

namespace texplorer::ui {

/// What the pointer rests on, in one line for the status bar, in English: the bar translates it.
struct Hint {
    std::string words; ///< empty: on nothing that has something to say
    bool isProblem = false;
};

/// Begins a frame. `room`: pixels that the status bar has for a hint; 0: hints are shown beside the pointer.
void beginHints(float room);

/// Ends it: what has something to say from here on says it beside the pointer. What was said.
Hint endHints();

/// Whether the status bar has room for these words in one line.
[[nodiscard]] bool fitsBelow(std::string_view words);

/// Says it there. The last one of a frame counts.
void hint(std::string words, bool isProblem = false);

} // namespace texplorer::ui
