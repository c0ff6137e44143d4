#pragma once

#include "app/stage/event.h"

#include <cstddef>
#include <deque>

namespace texplorer::stage {

/// What Dear ImGui knows of the input when a frame begins.
struct InputState {
    PointerMoved pointer;
    Modifiers modifiers;
    bool typing =
        false; ///< a text field has the keyboard and Control is up: letters count as text, not as keys
};

/// Dear ImGui 1.86 looks at mouse and keyboard once a frame: a key or a button that goes down and up in
/// between was never pressed, and the order of what changed is lost. This says how many of the waiting inputs
/// one frame can take so that nothing is lost; the others wait for the next one. At least 1 where any waits.
///   - A key or a button changes once, a modifier before everything that it modifies.
///   - The pointer rests for a frame before a button changes, so that what is below it knows.
///   - What a click leads to (a text field, a list) is there before keys and text arrive.
[[nodiscard]] std::size_t inputsForOneFrame(const std::deque<Input>& waiting, const InputState& before);

/// The inputs on their way to Dear ImGui, whose context must be current.
class InputQueue {
public:
    void add(const Input& input);
    [[nodiscard]] bool empty() const { return waiting_.empty(); }

    /// Gives Dear ImGui what one frame can take. Right before ImGui::NewFrame.
    void feed();

private:
    void apply(const Input& input);

    std::deque<Input> waiting_;
    bool outside_ = false; ///< the pointer has left while a button was held
};

} // namespace texplorer::stage
