#pragma once

// Applies the keys of a lesson to a scene.

#include "texplorer/lesson/lesson.h"
#include "texplorer/scene/scene.h"

#include <vector>

namespace texplorer::lesson {

/// The index of each key's choice in a scene; 0 for keys that add.
using ChosenChoices = std::vector<std::size_t>;

/// Finds the choices of a scene. If several or none fit, the `remembered` ones are kept: parameters that one
/// key overrides do not identify the choices of others.
[[nodiscard]] ChosenChoices choicesOf(const Scene& scene, const std::vector<LessonKey>& keys,
                                      const ChosenChoices& remembered);

/// Selects the next choice of a key, then applies again the choices of keys with common parameters. Choices
/// that need more than `units` texture units are skipped. Errors: those of makeEdits; the scene is then
/// unchanged.
[[nodiscard]] Result<void> pressKey(Scene& scene, const std::vector<LessonKey>& keys, ChosenChoices& chosen,
                                    std::size_t key, int units = maxUnits);

/// Adds `times` increments. A model's spin is changed from its angle at `time`, so it does not jump. Errors:
/// those of setParam; OutOfRange at the limit of the number.
[[nodiscard]] Result<void> addTo(Scene& scene, const Addition& addition, float times, double time);

/// The number that it adds to.
[[nodiscard]] Result<float> numberOf(const Scene& scene, const Addition& addition);

/// Checks that a scene has the parameters of a key. The error names the missing one.
[[nodiscard]] Result<void> checkKey(const Scene& scene, const LessonKey& key);

} // namespace texplorer::lesson
