#pragma once

// Which random scenes can't be held to a rule, by a row with its reason: what core/conform/skip.h says of any
// scene, and what only chance puts together.

#include "tests/random/random_scene.h"
#include "texplorer/conform/pair.h"
#include "texplorer/diagnosis/diagnosis.h"

#include <span>
#include <string_view>
#include <vector>

namespace texplorer::random {

/// Two pictures of a scene that might be compared.
struct Comparison {
    const RandomScene& random;
    const std::vector<Finding>& findings; ///< of the scene's diagnosis
    conform::Pair pair;
    const conform::Driver& driver;
};

struct RandomSkip {
    std::string_view name;
    bool (*applies)(const Comparison& comparison);
    std::string_view reason;
};

[[nodiscard]] std::span<const RandomSkip> randomSkips();

struct Skipped {
    std::string_view name;
    std::string_view reason;
};

/// Why these two can't be compared by this scene; an empty name: they can.
[[nodiscard]] Skipped skipOf(const Comparison& comparison);

/// Whether a mesh has the same triangle, line or point twice, as random indices may have it, or a torus is
/// flat and lies on itself.
[[nodiscard]] bool drawsAPartTwice(const Model& model);

/// The reason that belongs to a skip's name.
[[nodiscard]] std::string_view reasonOf(std::string_view name);

} // namespace texplorer::random
