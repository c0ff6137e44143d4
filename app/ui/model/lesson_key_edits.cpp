#include "app/ui/model/lesson_key_edits.h"

#include "app/ui/model/lesson_run.h"
#include "app/ui/model/session.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace texplorer::ui {

bool isUsable(const LessonRun& run, std::size_t key) {
    return key < run.usable.size() && run.usable[key];
}

bool isTakenByLesson(const Session& session, std::string_view key) {
    const std::optional<LessonRun>& run = session.lesson;
    if (!run)
        return false;
    const std::vector<lesson::LessonKey>& keys = run->lesson.keys;
    const auto found = std::ranges::find(keys, key, &lesson::LessonKey::key);
    return found != keys.end() && isUsable(*run, static_cast<std::size_t>(found - keys.begin()));
}

void pressLessonKeys(const Session& session, std::span<const KeyPress> presses) {
    const std::optional<LessonRun>& run = session.lesson;
    if (!run || presses.empty())
        return;
    Sentence words;
    Scene sum = presentScene(session); // of the additions
    for (const KeyPress& press : presses) {
        if (!isUsable(*run, press.key))
            continue;
        const lesson::LessonKey& pressed = run->lesson.keys[press.key];
        if (const auto* addition = std::get_if<lesson::Addition>(&pressed.effect)) {
            // At the end of its range a number stays unchanged, without a message.
            static_cast<void>(addTo(sum, *addition, press.times, session.look.playback.time));
            words = Sentence("Key {0}", pressed.key);
            continue;
        }
        lesson::ChosenChoices chosen = run->chosen;
        Scene changed = presentScene(session);
        if (!pressKey(changed, run->lesson.keys, chosen, press.key, session.window.textureUnits))
            continue;
        submit(session, Sentence("Key {0}", pressed.key), [&](Scene& scene) { scene = changed; });
        const bool isOverridden = changed == presentScene(session); // by another key's choice
        act(session, [isOverridden, made = PressedKey{std::move(changed), std::move(chosen)}](Session& s) {
            if (!s.lesson)
                return;
            if (isOverridden)
                s.lesson->chosen = made.chosen;
            else
                s.lesson->pressed = made;
        });
    }
    submitDrag(session, words, [&](Scene& scene) { scene = std::move(sum); });
}

void releaseLessonKey(const Session& session) {
    sealEdit(session);
}

std::string stateOfKey(const Session& session, const LessonRun& run, std::size_t key) {
    const lesson::LessonKey& which = run.lesson.keys[key];
    if (const auto* addition = std::get_if<lesson::Addition>(&which.effect)) {
        const Result<float> number = numberOf(presentScene(session), *addition);
        return number ? fmt::format("{:.2f}", *number) : std::string();
    }
    const auto& choices = std::get<lesson::Cycle>(which.effect).choices;
    const std::size_t chosen = key < run.chosen.size() ? run.chosen[key] : 0;
    return chosen < choices.size() ? run.text(choices[chosen].label) : std::string();
}

} // namespace texplorer::ui
