#pragma once

// Which random scenes can't be held to a rule, by a row with its reason: what core/conform/skip.h says of any
// scene, and what only chance puts together.

#include "tests/random/random_scene.h"

#include "core/conform/pair.h"

#include <span>
#include <string_view>

namespace texplorer::random {

struct RandomSkip {
    std::string_view name;
    bool (*applies)(const RandomScene& scene, const conform::Pair& pair);
    std::string_view reason;
};

[[nodiscard]] std::span<const RandomSkip> randomSkips();

struct Skipped {
    std::string_view name;
    std::string_view reason;
};

/// Why these two can't be compared by this scene; an empty name: they can.
[[nodiscard]] Skipped skipOf(const RandomScene& scene, const conform::Pair& pair, const conform::Driver& driver);

} // namespace texplorer::random
