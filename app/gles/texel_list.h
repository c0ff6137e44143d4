#pragma once

#include "texplorer/reference/sampling/sampled_texture.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace texplorer::gles {

/// All texels of a texture, as shaders/sampling.glsl reads them.
struct TexelList {
    int rows = 0;             ///< of glsl::texelsPerRow texels
    bool floats = false;      ///< four floats for each texel, instead of four bytes
    bool isUnclamped = false; ///< texels may lie outside 0 … 1
    Bytes texels;
    /// By GL's level number: width, height and depth, with the border, and the first texel. For a cube map
    /// the depth is 6. Empty for a level that does not exist, or whose faces differ.
    std::vector<std::optional<glm::ivec4>> levels;
};

/// May throw std::bad_alloc.
[[nodiscard]] TexelList texelList(const reference::SampledTexture& texture);

/// The number of texels in it, without making it.
[[nodiscard]] std::size_t texelCount(const reference::SampledTexture& texture);

/// The rows of so many texels.
[[nodiscard]] std::size_t rowsFor(std::size_t texels);

} // namespace texplorer::gles
