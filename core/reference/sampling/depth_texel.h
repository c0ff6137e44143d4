#pragma once

// Depth textures: OpenGL 2.1, section 3.8.14.

#include "texplorer/reference/sampling/comparison.h"
#include "texplorer/reference/sampling/sampled_texture.h"

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

/// r for the comparison: clamped to [0, 1], like stored depths. NaN becomes 0.
[[nodiscard]] inline float comparedDepth(float r) {
    return std::isnan(r) ? 0 : std::clamp(r, 0.0F, 1.0F);
}

/// The texture source colour of one texel of a depth texture: its depth, or 1 or 0 for whether the comparison
/// of r passes, in the components of GL_DEPTH_TEXTURE_MODE. These are filtered like colours.
[[nodiscard]] inline glm::vec4 depthColor(const SampledTexture& texture, float depth, float r) {
    if (texture.compareMode == CompareMode::None)
        return sourceColor(texture.format, glm::vec4(depth));
    const bool passed = passes<float>(texture.compareFunc, comparedDepth(r), depth);
    return sourceColor(texture.format, glm::vec4(passed ? 1 : 0));
}

} // namespace texplorer::reference
