#include "app/ui/widgets/input_queue.h"

#include "app/ui/widgets/keys.h"

#include <algorithm>
#include <vector>

namespace texplorer::ui {
namespace {

bool isModifier(int code) {
    return code >= key::firstModifier && code <= key::lastModifier;
}

/// Enter, the arrows, Backspace …: keys that mean something else than a letter to a text field.
bool isFunction(int code) {
    return code >= key::escape && !isModifier(code);
}

} // namespace

std::size_t eventsForOneFrame(const std::deque<KeyEvent>& waiting, bool typing) {
    std::vector<int> changed;
    bool anyKey = false;      // other than a modifier
    bool anyFunction = false; // was pressed
    bool anyCharacter = false;
    bool modified = false; // a modifier was pressed: what follows is no text
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        const KeyEvent& event = waiting[i];
        if (event.kind == KeyEvent::Kind::Character) {
            if (anyFunction)
                return i;
            anyCharacter = true;
            continue;
        }
        if (event.kind == KeyEvent::Kind::Repeat)
            continue; // Dear ImGui repeats by itself; a frame for each, and a slow window lags behind the
                      // hand
        if (typing && !modified && event.code < key::escape)
            continue;
        const bool twice = std::ranges::find(changed, event.code) != changed.end();
        const bool outOfOrder = (isModifier(event.code) && (anyKey || anyCharacter)) ||
                                (anyCharacter && (isFunction(event.code) || modified));
        if (twice || outOfOrder)
            return std::max<std::size_t>(i, 1);
        changed.push_back(event.code);
        anyKey |= !isModifier(event.code);
        anyFunction |= isFunction(event.code) && event.kind != KeyEvent::Kind::Release;
        modified |= isModifier(event.code);
    }
    return waiting.size();
}

} // namespace texplorer::ui
