#pragma once

// Which levels a texture will have, without making any: what completeness and size limits can be judged by.

#include "core/texture/texture_pictures.h"

#include <optional>
#include <vector>

namespace texplorer {

struct PlannedLevel {
    int number = 0; ///< GL's: 0 is the base
    int width = 0;  ///< extents without a border
    int height = 1;
    int depth = 1;

    bool operator==(const PlannedLevel&) const = default;
};

struct LevelPlan {
    std::vector<PlannedLevel> levels;  ///< ascending; those of every face alike
    int lastLevel = 1000;              ///< as TextureLevels has it
    int border = 0;                    ///< as TextureLevels has it
    std::optional<BlockFormat> blocks; ///< kept from the file, or what the driver shall compress to
};

/// The extents that a level has above a base (OpenGL 2.1, section 3.8.8).
[[nodiscard]] PlannedLevel levelAbove(const PlannedLevel& base, int number);

/// The numbers and extents that prepareLevels would give, at once for any size; outlines will do. Empty for
/// an empty image.
[[nodiscard]] LevelPlan planLevels(const Texture& texture, const TexturePictures& pictures, Target target);

} // namespace texplorer
