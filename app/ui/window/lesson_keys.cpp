#include "app/ui/model/lesson_key_edits.h"
#include "app/ui/model/lesson_run.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/window/shortcuts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace texplorer::ui {
namespace {

struct NamedKey {
    std::string_view name;
    int code;
};
constexpr std::array namedKeys{
    NamedKey{N_("Up"), key::up},
    NamedKey{N_("Down"), key::down},
    // Translators: names of keys of the keyboard
    NamedKey{N_("Left"), key::left},
    NamedKey{N_("Right"), key::right},
    NamedKey{N_("Page Up"), key::pageUp},
    NamedKey{N_("Page Down"), key::pageDown},
    NamedKey{N_("Home"), key::home},
    NamedKey{N_("End"), key::end},
    NamedKey{N_("Insert"), key::insert},
    NamedKey{N_("Delete"), key::del},
    NamedKey{N_("Space"), key::space},
};
static_assert(std::ranges::equal(namedKeys, lesson::keyNames, {}, &NamedKey::name));

int codeOfKey(std::string_view name) {
    const auto* named = std::ranges::find(namedKeys, name, &NamedKey::name);
    return named != namedKeys.end() ? named->code : name.front(); // letters and digits have their own codes
}

/// As in a program that polls its keys in each frame, at the frame rate of its time.
constexpr float framesASecond = 60;

bool areKeysFree(const Session& session, bool popup) {
    const ImGuiIO& io = ImGui::GetIO();
    return !popup && session.asking.dialog == Dialog::None && !session.out.keyTaken && !io.WantTextInput &&
           !io.KeyCtrl && !io.KeyShift && !io.KeyAlt && !io.KeySuper && !ImGui::IsAnyItemActive();
}

} // namespace

void takeLessonKeys(Session& session, bool popup) {
    std::optional<LessonRun>& run = session.lesson;
    if (!run)
        return;
    const bool held = run->holdsKey;
    run->holdsKey = false;
    run->heldKey.reset();
    std::vector<KeyPress> presses;
    if (areKeysFree(session, popup)) {
        for (std::size_t i = 0; i < run->lesson.keys.size(); ++i) {
            const lesson::LessonKey& each = run->lesson.keys[i];
            const int code = codeOfKey(each.key);
            if (!isUsable(*run, i) || !isKeyDown(code))
                continue;
            session.out.keyTaken = true;
            run->heldKey = i;
            const bool pressed = isKeyPressed(code, false);
            const bool goesOn = std::holds_alternative<lesson::Addition>(each.effect);
            run->holdsKey |= goesOn;
            if (pressed)
                presses.push_back({i});
            else if (goesOn && held)
                presses.push_back({i, ImGui::GetIO().DeltaTime * framesASecond});
        }
    }
    pressLessonKeys(session, presses);
    if (held && !run->holdsKey)
        releaseLessonKey(session);
}

} // namespace texplorer::ui
