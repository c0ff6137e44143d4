#pragma once

// Images of depths: one number of 32 bits a pixel, from 0, the nearest, to 2^32 - 1, the farthest.

#include "core/image/image.h"

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

/// A depth of so many bits, 8 to 32, as the nearest of 32: both ends stay ends, and to cut the lower bits off
/// again or to round gives the same.
[[nodiscard]] constexpr std::uint32_t widenedDepth(std::uint32_t depth, int bits) {
    const std::uint64_t most = (std::uint64_t{1} << bits) - 1;
    return static_cast<std::uint32_t>((depth * std::uint64_t{farthestDepth32} + most / 2) / most);
}

/// The nearest of 255ths.
[[nodiscard]] constexpr int greyOfDepth(std::uint32_t depth) {
    return static_cast<int>((depth * std::uint64_t{255} + farthestDepth32 / 2) / farthestDepth32);
}

/// How many of them count in what the light sees (core/reference/light_depth.h).
inline constexpr int lightDepthBits = 24;

/// The image's red, or its depths, as a texture of `bits` bits a depth (16 or 24) keeps them: Depth32. An
/// image of alpha alone has no red: 0.
[[nodiscard]] Image depthsOf(const Image& image, int bits);

/// Depths as greys: Luminance8. An image of another format is returned as it is.
[[nodiscard]] Image greysOf(Image image);

} // namespace texplorer
