#pragma once

// Images of depths: one number of 32 bits per pixel, from 0, the nearest, to 2^32 - 1, the farthest.

#include "texplorer/image/image.h"

#include <cstdint>
#include <cstring>
#include <limits>

namespace texplorer {

inline constexpr std::uint32_t farthestDepth32 = std::numeric_limits<std::uint32_t>::max();

[[nodiscard]] inline std::uint32_t depthAt(const std::byte* pixel) {
    std::uint32_t depth = 0;
    std::memcpy(&depth, pixel, sizeof depth);
    return depth;
}

inline void storeDepth(std::uint32_t depth, std::byte* pixel) {
    std::memcpy(pixel, &depth, sizeof depth);
}

/// Extends a depth of 8 to 32 bits to 32 bits: both ends stay ends, and truncation and rounding to the old
/// number of bits give the old value.
[[nodiscard]] constexpr std::uint32_t widenedDepth(std::uint32_t depth, int bits) {
    const std::uint64_t max = (std::uint64_t{1} << bits) - 1;
    return static_cast<std::uint32_t>((depth * std::uint64_t{farthestDepth32} + max / 2) / max);
}

/// Rounded to 255ths.
[[nodiscard]] constexpr int greyOfDepth(std::uint32_t depth) {
    return static_cast<int>((depth * std::uint64_t{255} + farthestDepth32 / 2) / farthestDepth32);
}

/// The number of bits in the light's view (texplorer/reference/light_depth.h).
inline constexpr int lightDepthBits = 24;

/// Returns the image's red, or its depths, as a texture with `bits` bits per depth (16, 24 or 32) stores them:
/// Depth32. The red of an alpha image is 0.
[[nodiscard]] Image depthsOf(const Image& image, int bits);

/// Converts depths to Luminance8. Images of other formats are returned unchanged.
[[nodiscard]] Image greysOf(Image image);

} // namespace texplorer
