#pragma once

// The framebuffer's eight bits per component.

#include <glm/vec4.hpp>

#include <algorithm>
#include <cstddef>

namespace texplorer::reference {

/// Section 2.14.9: clamps, and rounds to the nearest of 256 values. NaN becomes 0.
inline void store(glm::vec4 color, std::byte* pixel) {
    for (int i = 0; i < 4; ++i) {
        const float value = color[i] > 0 ? std::min(color[i], 1.0F) : 0;
        pixel[i] = static_cast<std::byte>(static_cast<int>(value * 255.0F + 0.5F));
    }
}

[[nodiscard]] inline glm::vec4 colorOf(const std::byte* pixel) {
    glm::vec4 color;
    for (int i = 0; i < 4; ++i)
        color[i] = static_cast<float>(std::to_integer<int>(pixel[i])) / 255.0F;
    return color;
}

} // namespace texplorer::reference
