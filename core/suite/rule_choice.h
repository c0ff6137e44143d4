#pragma once

#include "core/conform/rule.h"
#include "core/scene/scene.h"
#include "core/texture/image_source.h"

#include <span>
#include <string_view>

namespace texplorer::suite {

/// The names that a suite's "rule" may have: "auto", "none" and those of core/conform/rule.h.
[[nodiscard]] std::span<const std::string_view> ruleNames();

/// nullptr: there is none of this name, or it is "auto" or "none".
[[nodiscard]] const conform::Rule* findRule(std::string_view name);

/// The rule of core/conform/features.cpp for what a scene uses, the widest where it uses several things:
/// anisotropy, levels of its own, blended levels, chosen levels, lines, compression, filters and edges of
/// texels (the same as a texture with GL_NEAREST), several passes, and without any texture the outline alone.
[[nodiscard]] const conform::Rule& ruleFor(const Scene& scene);

} // namespace texplorer::suite
