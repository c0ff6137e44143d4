#pragma once

#include "core/image/image.h"
#include "core/reference/triangle.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// A picture being drawn: eight bits a component and 24 bits of depth, as the GL framebuffer.
struct Canvas {
    Image color;                      ///< Rgba8, bottom row first
    std::vector<std::uint32_t> depth; ///< one a pixel

    /// Throws std::bad_alloc.
    Canvas(Viewport viewport, glm::vec4 background);
    [[nodiscard]] Viewport viewport() const { return {color.width, color.height}; }
};

inline constexpr std::uint32_t farthestDepth = (1U << 24) - 1;

} // namespace texplorer::reference
