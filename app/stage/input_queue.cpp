#include "app/stage/input_queue.h"

#include "app/ui/widgets/keys.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

namespace texplorer::stage {
namespace {

namespace key = ui::key;

constexpr PointerMoved nowhere{-FLT_MAX, -FLT_MAX}; // Dear ImGui's value for no position

bool isModifier(int code) {
    return code >= key::firstModifier && code <= key::lastModifier;
}

/// Enter, the arrows, Backspace …: keys that a text field uses as commands, not as letters.
bool isFunction(int code) {
    return code >= key::escape && !isModifier(code);
}

/// The input of the current frame. Each `take` returns whether there was room for one more input.
class FrameInput {
public:
    explicit FrameInput(const InputState& before)
        : pointer_(before.pointer)
        , modifiers_(before.modifiers)
        , typing_(before.typing) {}

    bool take(const PointerMoved& to) {
        if (pressed_ || turned_ || anyKey_ || anyText_ || focus_)
            return false;
        moved_ |= to.x != pointer_.x || to.y != pointer_.y;
        return true;
    }

    bool take(const PointerLeft& /*left*/) { return take(nowhere); }

    bool take(const ButtonChanged& event) {
        const bool again = std::ranges::find(buttons_, event.button) != buttons_.end();
        if (moved_ || turned_ || anyKey_ || anyText_ || again || !modify(event.modifiers))
            return false;
        buttons_.push_back(event.button);
        pressed_ = true;
        return true;
    }

    bool take(const WheelTurned& event) {
        if (moved_ || pressed_ || anyKey_ || anyText_ || !modify(event.modifiers))
            return false;
        turned_ = true;
        return true;
    }

    bool take(const KeyChanged& event) {
        if (event.kind == KeyChanged::Kind::Repeat)
            return true; // Dear ImGui repeats keys itself; with one frame for each, a slow window would lag
                         // behind
        if (pressed_ || turned_ || !modify(event.modifiers))
            return false;
        const bool modifier = isModifier(event.code);
        if (typing_ && !modified_ && event.code < key::escape)
            return true;
        const bool again = std::ranges::find(keys_, event.code) != keys_.end();
        const bool outOfOrder =
            (modifier && (anyKey_ || anyText_)) || (anyText_ && (isFunction(event.code) || modified_));
        if (again || outOfOrder)
            return false;
        keys_.push_back(event.code);
        anyKey_ |= !modifier;
        functionPressed_ |= isFunction(event.code) && event.kind == KeyChanged::Kind::Press;
        modified_ |= modifier;
        return true;
    }

    bool take(const TextEntered& /*text*/) {
        if (pressed_ || turned_ || functionPressed_ || focus_)
            return false;
        anyText_ = true;
        return true;
    }

    bool take(const FocusChanged& /*event*/) {
        if (moved_ || pressed_ || turned_ || anyKey_ || anyText_ || modified_)
            return false;
        focus_ = true; // it releases the keys: those that follow belong to another frame
        return true;
    }

private:
    /// A frame has one state of the modifiers, for all of its events.
    bool modify(const Modifiers& modifiers) {
        if (focus_ || (modifiers != modifiers_ && (pressed_ || turned_ || anyKey_ || anyText_)))
            return false;
        modifiers_ = modifiers;
        return true;
    }

    PointerMoved pointer_;
    Modifiers modifiers_;
    bool typing_;
    std::vector<int> keys_;    ///< that have changed
    std::vector<int> buttons_; ///< that have changed
    bool moved_ = false;
    bool pressed_ = false; ///< a button has changed
    bool turned_ = false;
    bool anyKey_ = false;          ///< other than a modifier
    bool functionPressed_ = false; ///< a key that is not a letter
    bool anyText_ = false;
    bool modified_ = false; ///< a modifier has changed: what follows is not text
    bool focus_ = false;
};

InputState stateOf(const ImGuiIO& io) {
    return {{io.MousePos.x, io.MousePos.y},
            {io.KeyCtrl, io.KeyShift, io.KeyAlt, io.KeySuper},
            io.WantTextInput && !io.KeyCtrl};
}

void setModifiers(const Modifiers& modifiers) {
    ui::setModifiers(modifiers.control, modifiers.shift, modifiers.alt, modifiers.super);
}

bool isAnyButtonHeld() {
    return std::ranges::any_of(ImGui::GetIO().MouseDown, [](bool down) { return down; });
}

std::optional<Press> pressOf(const Input& input) {
    if (const auto* key = std::get_if<KeyChanged>(&input))
        return Press{true, key->code};
    if (const auto* button = std::get_if<ButtonChanged>(&input))
        return Press{false, button->button};
    return std::nullopt;
}

bool isDown(const Input& input) {
    const auto* key = std::get_if<KeyChanged>(&input);
    const auto* button = std::get_if<ButtonChanged>(&input);
    return (key && key->kind == KeyChanged::Kind::Press) || (button && button->down);
}

void movePointer(const PointerMoved& to) {
    ImGui::GetIO().MousePos = {to.x, to.y};
}

template<class... Each>
struct Overloaded : Each... {
    using Each::operator()...;
};
template<class... Each>
Overloaded(Each...) -> Overloaded<Each...>; // some compilers don't deduce it

} // namespace

std::size_t inputsForOneFrame(const std::deque<Input>& waiting, const InputState& before) {
    FrameInput frame(before);
    const auto end = std::ranges::find_if_not(waiting, [&frame](const Input& input) {
        return std::visit([&frame](const auto& each) { return frame.take(each); }, input);
    });
    return static_cast<std::size_t>(end - waiting.begin());
}

void InputQueue::add(const Input& input) {
    if (!join(input) && !isTooMuch(input))
        waiting_.push_back(input);
}

/// A hidden or slow window may not read its input for a long time.
bool InputQueue::join(const Input& input) {
    const auto* key = std::get_if<KeyChanged>(&input);
    if (key && key->kind == KeyChanged::Kind::Repeat) // Dear ImGui repeats by itself
        return true;
    if (waiting_.empty() || waiting_.back().index() != input.index())
        return false;
    if (std::holds_alternative<PointerMoved>(input)) { // the places in between do not matter
        waiting_.back() = input;
        return true;
    }
    const auto* turn = std::get_if<WheelTurned>(&input);
    auto* last = std::get_if<WheelTurned>(&waiting_.back());
    if (!turn || turn->modifiers != last->modifiers)
        return false;
    last->x += turn->x;
    last->y += turn->y;
    return true;
}

bool InputQueue::isTooMuch(const Input& input) {
    const bool isText = std::holds_alternative<TextEntered>(input);
    const std::optional<Press> press = pressOf(input);
    if (!press && !isText)
        return false;
    if (press && !isDown(input))
        return std::erase(dropped_, *press) > 0;
    const auto max = isText || ImGui::GetIO().WantTextInput ? maxTyped : maxPresses;
    const auto isLikeIt = [&](const Input& each) {
        return isText ? std::holds_alternative<TextEntered>(each) : pressOf(each) && isDown(each);
    };
    if (waiting_.size() < max || static_cast<std::size_t>(std::ranges::count_if(waiting_, isLikeIt)) < max)
        return false;
    if (press)
        dropped_.push_back(*press);
    return true;
}

void InputQueue::feed() {
    if (outside_ && !isAnyButtonHeld()) {
        outside_ = false;
        movePointer(nowhere);
    }
    const auto count = static_cast<std::ptrdiff_t>(inputsForOneFrame(waiting_, stateOf(ImGui::GetIO())));
    const auto end = std::next(waiting_.begin(), count);
    std::for_each(waiting_.begin(), end, [this](const Input& input) { apply(input); });
    waiting_.erase(waiting_.begin(), end);
}

void InputQueue::apply(const Input& input) {
    ImGuiIO& io = ImGui::GetIO();
    std::visit(Overloaded{[&](const PointerMoved& event) {
                              outside_ = false;
                              movePointer(event);
                          },
                          [&](const PointerLeft&) {
                              outside_ = isAnyButtonHeld();
                              if (!outside_)
                                  movePointer(nowhere);
                          },
                          [&](const ButtonChanged& event) {
                              if (event.button < 0 || event.button >= ImGuiMouseButton_COUNT)
                                  return;
                              io.MouseDown[event.button] = event.down;
                              setModifiers(event.modifiers);
                          },
                          [&](const WheelTurned& event) {
                              io.MouseWheelH += event.x;
                              io.MouseWheel += event.y;
                              setModifiers(event.modifiers);
                          },
                          [&](const KeyChanged& event) {
                              setModifiers(event.modifiers);
                              ui::setKey(event.code, event.kind != KeyChanged::Kind::Release);
                          },
                          [&](const TextEntered& event) { ui::addCharacter(event.character); },
                          [&](const FocusChanged& event) { io.AddFocusEvent(event.focused); }},
               input);
}

} // namespace texplorer::stage
