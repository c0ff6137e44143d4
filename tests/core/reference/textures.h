#pragma once

// Small textures for the sampler, whose colours can be worked out by hand.

#include "texplorer/reference/sampling/lod.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace texplorer::test {

/// A level whose texel i, j, k has the colour that `color` says.
inline reference::Level makeLevel(glm::ivec3 size, const std::function<glm::vec4(int, int, int)>& color,
                                  int border = 0, int axes = 2) {
    reference::Level level;
    level.width = size.x;
    level.height = size.y;
    level.depth = size.z;
    level.border = border;
    const int marginY = axes > 1 ? border : 0;
    const int marginZ = axes > 2 ? border : 0;
    for (int k = -marginZ; k < size.z + marginZ; ++k)
        for (int j = -marginY; j < size.y + marginY; ++j)
            for (int i = -border; i < size.x + border; ++i)
                level.texels.push_back(color(i, j, k));
    return level;
}

/// A complete texture of size x size texels whose level n is n / 10 in red everywhere.
inline reference::SampledTexture leveledTexture(int size) {
    reference::SampledTexture texture;
    for (int n = 0; size >= 1; ++n, size /= 2)
        texture.levels.push_back(makeLevel(
            {size, size, 1}, [n](int, int, int) { return glm::vec4(static_cast<float>(n) / 10, 0, 0, 1); }));
    return texture;
}

/// Derivatives of so many texels of the base level a pixel, in s along x and in t along y.
inline reference::Derivatives texelsPerPixel(const reference::SampledTexture& texture, float x, float y) {
    const reference::Level& base = texture.levels[static_cast<std::size_t>(texture.baseLevel)];
    return {{x / static_cast<float>(base.width), 0, 0}, {0, y / static_cast<float>(base.height), 0}};
}

inline testing::AssertionResult isNear(glm::vec4 found, glm::vec4 expected, float bound = 1e-5F) {
    for (int i = 0; i < 4; ++i) {
        if (!(std::abs(found[i] - expected[i]) <= bound))
            return testing::AssertionFailure()
                   << "found (" << found.r << ", " << found.g << ", " << found.b << ", " << found.a
                   << "), expected (" << expected.r << ", " << expected.g << ", " << expected.b << ", "
                   << expected.a << ")";
    }
    return testing::AssertionSuccess();
}

} // namespace texplorer::test
