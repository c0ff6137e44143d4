#include "texplorer/lesson/lesson_keys.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/lesson/lesson_scene.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace texplorer::lesson {
namespace {

const std::vector<KeyChoice>& choicesIn(const LessonKey& key) {
    static const std::vector<KeyChoice> none;
    const auto* cycle = std::get_if<Cycle>(&key.effect);
    return cycle ? cycle->choices : none;
}

bool changes(const LessonKey& key, std::string_view path) {
    return std::ranges::any_of(choicesIn(key), [&](const KeyChoice& choice) {
        return std::ranges::any_of(choice.edits,
                                   [&](const Edit& edit) { return !path.empty() && pathOf(edit) == path; });
    });
}

bool sharesPaths(const LessonKey& a, const LessonKey& b) {
    return std::ranges::any_of(choicesIn(a), [&](const KeyChoice& choice) {
        return std::ranges::any_of(choice.edits, [&](const Edit& edit) { return changes(b, pathOf(edit)); });
    });
}

/// The keys that a key has parameters in common with, over others as well, and itself, in order.
std::vector<std::size_t> groupOf(const std::vector<LessonKey>& keys, std::size_t key) {
    std::vector<std::size_t> group{key};
    for (std::size_t next = 0; next < group.size(); ++next) {
        for (std::size_t other = 0; other < keys.size(); ++other) {
            if (std::ranges::find(group, other) == group.end() && sharesPaths(keys[group[next]], keys[other]))
                group.push_back(other);
        }
    }
    std::ranges::sort(group);
    return group;
}

Result<void> makeChoices(Scene& scene, const std::vector<LessonKey>& keys, const ChosenChoices& chosen,
                         const std::vector<std::size_t>& group) {
    std::vector<Edit> edits;
    for (const std::size_t key : group) {
        const std::vector<Edit>& each = choicesIn(keys[key]).at(chosen[key]).edits;
        edits.insert(edits.end(), each.begin(), each.end());
    }
    return makeEdits(scene, edits, "/edits");
}

bool holds(const Scene& scene, const std::vector<LessonKey>& keys, const ChosenChoices& chosen,
           const std::vector<std::size_t>& group) {
    Scene made = scene;
    return makeChoices(made, keys, chosen, group) && made == scene;
}

/// The next combination of a group's choices; false after the last.
bool turn(ChosenChoices& chosen, const std::vector<LessonKey>& keys, const std::vector<std::size_t>& group) {
    for (const std::size_t key : group) {
        if (++chosen[key] < choicesIn(keys[key]).size())
            return true;
        chosen[key] = 0;
    }
    return false;
}

void findChoices(const Scene& scene, const std::vector<LessonKey>& keys,
                 const std::vector<std::size_t>& group, ChosenChoices& chosen) {
    constexpr int maxTried = 512;
    if (holds(scene, keys, chosen, group))
        return;
    ChosenChoices tried = chosen;
    for (const std::size_t key : group)
        tried[key] = 0;
    for (int i = 0; i < maxTried; ++i) {
        if (holds(scene, keys, tried, group)) {
            chosen = tried;
            return;
        }
        if (!turn(tried, keys, group))
            return;
    }
}

/// The numbers of "0.5,1,0".
Result<std::vector<float>> numbersAt(const Scene& scene, const Addition& addition) {
    const Result<std::string> text = getParam(scene, addition.path);
    if (!text)
        return fail(text.error());
    std::vector<float> numbers;
    const char* const end = text->data() + text->size();
    for (const char* at = text->data(); at <= end;) {
        float number = 0;
        const auto [stop, error] = std::from_chars(at, end, number);
        if (error != std::errc() || (stop != end && *stop != ','))
            return fail(ErrorCode::Malformed,
                        Sentence("expected a parameter of numbers, found {0}", ProperName{inQuotes(*text)}),
                        addition.path);
        numbers.push_back(number);
        if (stop == end)
            break;
        at = stop + 1;
    }
    if (static_cast<std::size_t>(addition.component) >= numbers.size())
        return fail(ErrorCode::OutOfRange,
                    Sentence("expected one of {0} components, found number {1}", numbers.size(),
                             addition.component + 1),
                    addition.path);
    return numbers;
}

/// Models whose spin has changed are turned back to where they were.
void keepAngles(Scene& scene, const Scene& before, double time) {
    constexpr double full = 360;
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        Model& model = scene.models[i];
        for (int axis = 0; axis < 3; ++axis) {
            const float faster = model.spin[axis] - before.models[i].spin[axis];
            if (faster != 0)
                model.rotation[axis] = static_cast<float>(std::remainder(
                    static_cast<double>(model.rotation[axis]) - static_cast<double>(faster) * time, full));
        }
    }
}

} // namespace

ChosenChoices choicesOf(const Scene& scene, const std::vector<LessonKey>& keys,
                        const ChosenChoices& remembered) {
    ChosenChoices chosen(keys.size());
    for (std::size_t key = 0; key < keys.size(); ++key) {
        const std::size_t known = key < remembered.size() ? remembered[key] : 0;
        chosen[key] = known < choicesIn(keys[key]).size() ? known : 0;
    }
    for (std::size_t key = 0; key < keys.size(); ++key) {
        if (choicesIn(keys[key]).empty())
            continue;
        const std::vector<std::size_t> group = groupOf(keys, key);
        if (group.front() == key)
            findChoices(scene, keys, group, chosen);
    }
    return chosen;
}

Result<void> pressKey(Scene& scene, const std::vector<LessonKey>& keys, ChosenChoices& chosen,
                      std::size_t key, int units) {
    ChosenChoices next = choicesOf(scene, keys, chosen);
    const std::size_t count = choicesIn(keys[key]).size();
    for (std::size_t tried = 0; tried < count; ++tried) {
        next[key] = (next[key] + 1) % count;
        Scene edited = scene;
        if (const Result<void> made = makeChoices(edited, keys, next, groupOf(keys, key)); !made)
            return made;
        if (unitsUsed(edited) <= std::max(units, unitsUsed(scene))) {
            scene = std::move(edited);
            chosen = std::move(next);
            break;
        }
    }
    return {};
}

Result<float> numberOf(const Scene& scene, const Addition& addition) {
    const Result<std::vector<float>> numbers = numbersAt(scene, addition);
    if (!numbers)
        return fail(numbers.error());
    return (*numbers)[static_cast<std::size_t>(addition.component)];
}

Result<void> addTo(Scene& scene, const Addition& addition, float times, double time) {
    Result<std::vector<float>> numbers = numbersAt(scene, addition);
    if (!numbers)
        return fail(numbers.error());
    (*numbers)[static_cast<std::size_t>(addition.component)] += addition.amount * times;
    Scene edited = scene;
    if (const Result<void> set = setParam(edited, addition.path, formatNumbers(*numbers, ",")); !set)
        return set;
    keepAngles(edited, scene, time);
    scene = std::move(edited);
    return {};
}

Result<void> checkKey(const Scene& scene, const LessonKey& key) {
    if (const auto* addition = std::get_if<Addition>(&key.effect)) {
        Scene edited = scene;
        if (addTo(edited, *addition, 1, 0))
            return {};
        return addTo(edited, *addition, -1, 0); // it may be at one end
    }
    const std::vector<KeyChoice>& choices = choicesIn(key);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        Scene edited = scene;
        if (const Result<void> made = makeEdits(edited, choices[i].edits, "/edits"); !made)
            return fail(within(atPointer(fmt::format("/cycle/{}", i)), made.error()));
    }
    return {};
}

} // namespace texplorer::lesson
