#pragma once

#include "core/conform/rule.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::suite {

/// The names that a suite's "rule" may have: "auto", "none" and those of core/conform/rule.h.
[[nodiscard]] std::span<const std::string_view> ruleNames();

/// nullptr: there is none of this name, or it is "auto" or "none".
[[nodiscard]] const conform::Rule* findRule(std::string_view name);

/// What each rule allows a case, by what it allows: "1 % unexplained (texel-edge, level-choice), …".
[[nodiscard]] std::string ruleLimits();

/// The rule for what a scene uses, as core/conform/features.cpp has it for that feature alone; of several
/// things, the widest: anisotropy; levels that aren't made of each other; levels that are blended, or
/// textures in several passes; levels that are chosen; lines and points; textures; outlines alone. A case is
/// one scene: it is held to the rule's `bound`, `tolerance`, `explainedScene` and `nearScene`.
[[nodiscard]] const conform::Rule& ruleFor(const Scene& scene);

} // namespace texplorer::suite
