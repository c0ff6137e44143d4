#pragma once

#include "texplorer/conform/rule.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/image_source.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::suite {

/// The values of a suite's "rule": "auto", "none" and the names of texplorer/conform/rule.h.
[[nodiscard]] std::span<const std::string_view> ruleNames();

/// Returns nullptr for an unknown name, "auto" and "none".
[[nodiscard]] const conform::Rule* findRule(std::string_view name);

/// What each rule allows in a case, sorted by limits: "1 % unexplained (texel-edge, level-choice), …".
[[nodiscard]] std::string ruleLimits();

/// Returns the rule for the features that a scene uses, as assigned in core/conform/features.cpp; for several
/// features the widest, in this order: anisotropy; levels that are not made from each other; blended levels,
/// or textures in several passes; chosen levels; lines and points; textures; outlines only. A case is one
/// scene, so the rule's `bound`, `tolerance`, `explainedScene` and `nearScene` apply.
[[nodiscard]] const conform::Rule& ruleFor(const Scene& scene);

} // namespace texplorer::suite
