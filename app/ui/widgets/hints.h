#pragma once

#include <string>
#include <string_view>

namespace texplorer::ui {

/// One line of help for the item under the pointer, in English: the status bar translates it.
struct Hint {
    std::string words; ///< empty: the item has no help
    bool isProblem = false;
};

/// Begins a frame. `room`: pixels for a hint in the status bar; 0: hints are shown as tooltips.
void beginHints(float room);

/// Ends the collection of hints: later ones in this frame are shown as tooltips. Returns the hint for the
/// status bar.
Hint endHints();

/// Whether these words fit into one line of the status bar.
[[nodiscard]] bool fitsBelow(std::string_view words);

/// Shows the words there. The last hint of a frame is used.
void hint(std::string words, bool isProblem = false);

} // namespace texplorer::ui
