#pragma once

// Textures of depths: OpenGL 2.1, section 3.8.14.

#include "core/reference/sampling/comparison.h"
#include "core/reference/sampling/sampled_texture.h"

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

/// What r is compared as: it is clamped to [0, 1], as stored depths are. NaN counts as 0.
[[nodiscard]] inline float comparedDepth(float r) {
    return std::isnan(r) ? 0 : std::clamp(r, 0.0F, 1.0F);
}

/// The texture source colour of one texel of a depth texture: its depth, or 1 where r passes against it and 0
/// where not, as GL_DEPTH_TEXTURE_MODE says. What several texels give is filtered as colours are.
[[nodiscard]] inline glm::vec4 depthColor(const SampledTexture& texture, float depth, float r) {
    if (texture.compareMode == CompareMode::None)
        return sourceColor(texture.format, glm::vec4(depth));
    const bool passed = passes<float>(texture.compareFunc, comparedDepth(r), depth);
    return sourceColor(texture.format, glm::vec4(passed ? 1 : 0));
}

} // namespace texplorer::reference
