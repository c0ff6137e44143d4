#pragma once

#include <cstddef>
#include <deque>

namespace texplorer::ui {

/// A keyboard event, in the order in which it happened.
struct KeyEvent {
    enum class Kind { Press, Repeat, Release, Character };
    Kind kind;
    int code; ///< as in app/ui/widgets/keys.h, or a Unicode code point
    int scancode = 0;

    bool operator==(const KeyEvent&) const = default;
};

/// Dear ImGui 1.86 looks at the keyboard once a frame: a key that goes down and up in between was never
/// pressed, and the order of what changed is lost. This says how many of the waiting events one frame can
/// take so that nothing is lost; the others wait for the next one. At least 1 where any waits. `typing`: a
/// text field has the keyboard and Control is up, so that letters count as text and not as keys.
[[nodiscard]] std::size_t eventsForOneFrame(const std::deque<KeyEvent>& waiting, bool typing);

} // namespace texplorer::ui
