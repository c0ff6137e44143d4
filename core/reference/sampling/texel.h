#pragma once

#include "texplorer/reference/sampling/sampled_texture.h"

#include <cstddef>

namespace texplorer::reference {

/// Whether a texel is neither in the level nor in its border image: then the border colour is used (OpenGL
/// 2.1, section 3.8.8, below equation 3.23).
[[nodiscard]] inline bool isBeyond(const Level& level, glm::ivec3 index, int axes) {
    for (int axis = 0; axis < axes; ++axis) {
        if (index[axis] < -level.border || index[axis] >= level.size()[axis] + level.border)
            return true;
    }
    return false;
}

/// tau_ijk. Index 0 is the first texel after the border.
[[nodiscard]] inline const glm::vec4& texelAt(const Level& level, glm::ivec3 index, int axes) {
    const auto stored = [&](int axis) {
        const int place = index[axis] + (axis < axes ? level.border : 0);
        return static_cast<std::size_t>(place);
    };
    const auto extent = [&](int axis) {
        const int texels = level.size()[axis] + (axis < axes ? 2 * level.border : 0);
        return static_cast<std::size_t>(texels);
    };
    return level.texels[(stored(2) * extent(1) + stored(1)) * extent(0) + stored(0)];
}

} // namespace texplorer::reference
