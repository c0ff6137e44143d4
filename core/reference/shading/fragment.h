#pragma once

// Per-fragment operations: OpenGL 2.1, section 4.1.

#include "texplorer/reference/sampling/comparison.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace texplorer::reference {

/// Section 4.1.4: alpha and the reference are compared as fixed-point numbers with the framebuffer's eight
/// bits of alpha (section 2.14.9). NaN becomes 0.
[[nodiscard]] constexpr bool passes(CompareFunc function, float alpha, float reference) {
    const auto fixedPoint = [](float value) {
        return value > 0 ? static_cast<int>((value < 1 ? value : 1) * 255 + 0.5F) : 0;
    };
    return passes<int>(function, fixedPoint(alpha), fixedPoint(reference));
}

/// Table 4.2.
[[nodiscard]] inline glm::vec4 blendFactor(BlendFactor factor, glm::vec4 source, glm::vec4 destination) {
    switch (factor) {
    case BlendFactor::Zero:
        return glm::vec4(0);
    case BlendFactor::One:
        return glm::vec4(1);
    case BlendFactor::SrcColor:
        return source;
    case BlendFactor::OneMinusSrcColor:
        return 1.0F - source;
    case BlendFactor::SrcAlpha:
        return glm::vec4(source.a);
    case BlendFactor::OneMinusSrcAlpha:
        return glm::vec4(1 - source.a);
    case BlendFactor::DstAlpha:
        return glm::vec4(destination.a);
    case BlendFactor::OneMinusDstAlpha:
        return glm::vec4(1 - destination.a);
    case BlendFactor::DstColor:
        return destination;
    case BlendFactor::OneMinusDstColor:
        return 1.0F - destination;
    }
    return glm::vec4(1);
}

/// Section 4.1.8, with GL_FUNC_ADD.
[[nodiscard]] inline glm::vec4 blend(BlendFactor sourceFactor, BlendFactor destinationFactor,
                                     glm::vec4 source, glm::vec4 destination) {
    return glm::clamp(source * blendFactor(sourceFactor, source, destination) +
                          destination * blendFactor(destinationFactor, source, destination),
                      0.0F, 1.0F);
}

} // namespace texplorer::reference
