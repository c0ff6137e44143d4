#pragma once

// What the keys of a lesson make of a scene.

#include "core/lesson/lesson.h"
#include "core/scene/scene.h"

#include <vector>

namespace texplorer::lesson {

/// Which choice of each key a scene has; what only adds has 0.
using ChosenChoices = std::vector<std::size_t>;

/// Which choices a scene has. Where several would do, or none does, those that are `remembered` stay: what
/// one key has the last word in says nothing of the others.
[[nodiscard]] ChosenChoices choicesOf(const Scene& scene, const std::vector<LessonKey>& keys,
                                      const ChosenChoices& remembered);

/// A press of a key that goes through choices: the next one of it, and of the keys that have parameters in
/// common with it their own again. A choice that takes more than `units` texture units is passed over.
/// Errors: those of makeEdits; nothing has changed then.
[[nodiscard]] Result<void> pressKey(Scene& scene, const std::vector<LessonKey>& keys, ChosenChoices& chosen,
                                    std::size_t key, int units = maxUnits);

/// So many times what it adds. A model's spin changes from where the model is at `time`: it doesn't jump.
/// Errors: those of setParam, OutOfRange where the number has come to its end.
[[nodiscard]] Result<void> addTo(Scene& scene, const Addition& addition, float times, double time);

/// The number that it adds to.
[[nodiscard]] Result<float> numberOf(const Scene& scene, const Addition& addition);

/// Whether a scene has what a key changes. Errors: what it hasn't.
[[nodiscard]] Result<void> checkKey(const Scene& scene, const LessonKey& key);

} // namespace texplorer::lesson
