#pragma once

#include "app/stage/event.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace texplorer::stage {

/// Dear ImGui's state of the input at the beginning of a frame.
struct InputState {
    PointerMoved pointer;
    Modifiers modifiers;
    bool typing = false; ///< a text field has the keyboard and Control is up: letters are text, not keys
};

/// Dear ImGui 1.86 looks at mouse and keyboard once a frame: a key or a button that goes down and up in
/// between was never pressed, and the order of what changed is lost. This says how many of the waiting inputs
/// one frame can take so that nothing is lost; the others wait for the next one. At least 1 where any waits.
///   - A key or a button changes once, a modifier before everything that it modifies.
///   - The pointer rests for a frame before a button changes, so that what is below it knows.
///   - What a click leads to (a text field, a list) is there before keys and text arrive.
[[nodiscard]] std::size_t inputsForOneFrame(const std::deque<Input>& waiting, const InputState& before);

/// A change of a key or a button.
struct Press {
    bool isKey;
    int code;

    bool operator==(const Press&) const = default;
};

/// Queues input for Dear ImGui, whose context must be current.
class InputQueue {
public:
    /// Input that arrives faster than frames are drawn is joined if nothing is lost: moves, turns of the
    /// wheel, repeated keys. At most maxPresses keys and buttons are kept, and at most maxTyped while text is
    /// typed, so that a slow window does not fall further behind.
    void add(const Input& input);
    static constexpr std::size_t maxPresses = 64;
    static constexpr std::size_t maxTyped = 4096;
    [[nodiscard]] bool empty() const { return waiting_.empty(); }

    /// Passes to Dear ImGui what one frame can take. Call it right before ImGui::NewFrame.
    void feed();

private:
    void apply(const Input& input);
    [[nodiscard]] bool join(const Input& input);
    [[nodiscard]] bool isTooMuch(const Input& input);

    std::deque<Input> waiting_;
    std::vector<Press> dropped_; ///< their releases are dropped as well
    bool outside_ = false;       ///< the pointer has left the window while a button was held
};

} // namespace texplorer::stage
