#pragma once

#include "core/image/image.h"
#include "core/reference/triangle.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace texplorer::reference {

/// A picture being drawn: eight bits a component and 24 bits of depth, as the GL framebuffer. The rasteriser
/// clears it, with what it draws first: a tile that is in a processor's cache is drawn at once.
struct Canvas {
    Image color;                           ///< Rgba8, bottom row first
    std::vector<std::uint32_t> depth;      ///< one a pixel
    std::array<std::byte, 4> background{}; ///< a pixel
    bool cleared = false;

    /// `memory` is used for `depth` where it is large enough. Throws std::bad_alloc.
    Canvas(Viewport viewport, glm::vec4 clearColor, std::vector<std::uint32_t> memory = {});

    [[nodiscard]] Viewport viewport() const { return {color.width, color.height}; }
    [[nodiscard]] std::size_t pixelAt(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(color.width) +
               static_cast<std::size_t>(x);
    }
};

inline constexpr std::uint32_t farthestDepth = (1U << 24) - 1;

} // namespace texplorer::reference
