#pragma once

// A level as a person looks at it: colours of 8 bits, and how often each occurs.

#include "core/reference/sampling/sampled_texture.h"

#include <array>
#include <cstdint>

namespace texplorer::reference {

/// A level as texture source colours (table 3.20), Rgba8, bottom row first and upright whatever a late flip
/// is to do, without its border. Numbers of sRGB are as they are stored. Of a volume the middle slice, of a
/// cube map the faces as a cross. Error: NotFound, there is no such level.
[[nodiscard]] Result<Image> levelPicture(const TextureLevels& levels, int number, Target target);

/// Of one component of all texels.
struct ComponentStatistics {
    std::array<std::uint32_t, 256> counts{}; ///< how many texels have this value
    int least = 0;
    int most = 0;
    double mean = 0;
};

/// Of red, green, blue, alpha, and of the luminance.
struct TexelStatistics {
    static constexpr std::size_t luminance = 4;
    std::array<ComponentStatistics, 5> components;
};

/// Of an Rgba8 image that isn't empty.
[[nodiscard]] TexelStatistics statisticsOf(const Image& image);

/// ITU-R BT.709's weights of red, green and blue, to the nearest number.
[[nodiscard]] constexpr int luminanceOf(int red, int green, int blue) {
    return (2126 * red + 7152 * green + 722 * blue + 5000) / 10000;
}

} // namespace texplorer::reference
