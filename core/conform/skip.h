#pragma once

// Comparisons that are skipped: each by a row with its reason, and counted.

#include "texplorer/conform/pair.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string_view>

namespace texplorer::conform {

struct Skip {
    std::string_view name;
    bool (*applies)(const Scene& scene, const Pair& pair, const Driver& driver);
    std::string_view reason;
};

[[nodiscard]] std::span<const Skip> skips();

/// Returns why these two cannot be compared with this scene; nullptr if they can.
[[nodiscard]] const Skip* skipOf(const Scene& scene, const Pair& pair, const Driver& driver);

} // namespace texplorer::conform
