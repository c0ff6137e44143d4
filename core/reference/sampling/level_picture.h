#pragma once

// A level as a picture for users: colours of 8 bits, and their histogram.

#include "texplorer/reference/sampling/sampled_texture.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// A level as texture source colours (table 3.20), Rgba8, bottom row first, upright even with a late flip,
/// without its border. sRGB numbers are as stored. Of a volume the middle slice, of a cube map the faces as a
/// cross. Error: NotFound if the level does not exist.
[[nodiscard]] Result<Image> levelPicture(const TextureLevels& levels, int number, Target target);

/// The texture source colours of an image in that format (OpenGL 2.1, tables 3.15 and 3.20) without its
/// border: Rgba8, rows in the same order. Floats are limited to 0 … 1. Of a volume the middle slice.
[[nodiscard]] Image sourceColors(const Image& image, BaseFormat format, int borderS = 0, int borderT = 0);

/// Statistics of a component over all texels.
struct ComponentStatistics {
    std::array<std::uint32_t, 256> counts{}; ///< the number of texels with each value
    int least = 0;
    int most = 0;
    double mean = 0;
};

/// For red, green, blue, alpha, and luminance.
struct TexelStatistics {
    static constexpr std::size_t luminance = 4;
    std::array<ComponentStatistics, 5> components;
};

/// For an Rgba8 image that is not empty.
[[nodiscard]] TexelStatistics statisticsOf(const Image& image);

/// Luminance by the weights of ITU-R BT.709, rounded to nearest.
[[nodiscard]] constexpr int luminanceOf(int red, int green, int blue) {
    return (2126 * red + 7152 * green + 722 * blue + 5000) / 10000;
}

} // namespace texplorer::reference
