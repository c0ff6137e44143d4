#pragma once

#include "texplorer/image/pixel_format.h"

#include <array>
#include <vector>

namespace texplorer {

/// The index of the alpha component, or -1.
[[nodiscard]] constexpr int alphaComponent(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
        return 0;
    case PixelFormat::LuminanceAlpha8:
        return 1;
    case PixelFormat::Rgba8:
        return 3;
    case PixelFormat::Luminance8:
    case PixelFormat::Rgb8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        break;
    }
    return -1;
}

/// The curve of sRGB (IEC 61966-2-1) between stored values of 8 bits and linear light of 16 bits. Every
/// stored value converts back to itself.
struct LinearLight {
    std::array<std::uint16_t, 256> light{};
    std::array<float, 256> exactLight{}; ///< 0 to 1
    std::vector<std::uint8_t> stored;    ///< 65536 entries, one for each amount of light

    static const LinearLight& table(); ///< computed on first use
};

} // namespace texplorer
