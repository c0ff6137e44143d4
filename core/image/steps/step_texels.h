#pragma once

// Texels as the steps of a preparation see them: red, green, blue and alpha, whatever the format stores.

#include "texplorer/image/convert.h"
#include "texplorer/image/linear_light.h"

#include <array>
#include <cstdint>

namespace texplorer {

/// Red, green, blue and alpha of a texel.
using Components = std::array<std::uint8_t, 4>;

/// The inverse of rgbaOf, for components that the format can hold.
inline void storeTexel(PixelFormat format, const Components& from, std::byte* texel) {
    switch (format) {
    case PixelFormat::Alpha8:
        texel[0] = std::byte{from[3]};
        return;
    case PixelFormat::LuminanceAlpha8:
        texel[1] = std::byte{from[3]};
        [[fallthrough]];
    case PixelFormat::Luminance8:
        texel[0] = std::byte{from[0]};
        return;
    case PixelFormat::Rgba8:
        texel[3] = std::byte{from[3]};
        [[fallthrough]];
    case PixelFormat::Rgb8:
        for (std::size_t i = 0; i < 3; ++i)
            texel[i] = std::byte{from[i]};
        return;
    case PixelFormat::Depth32: // which no step makes
    case PixelFormat::RgbaFloat:
        return;
    }
}

[[nodiscard]] inline std::uint8_t luminanceOf(const Components& color) {
    return static_cast<std::uint8_t>((299 * color[0] + 587 * color[1] + 114 * color[2] + 500) / 1000);
}

[[nodiscard]] constexpr bool isGrey(PixelFormat format) {
    return format == PixelFormat::Luminance8 || format == PixelFormat::LuminanceAlpha8;
}

[[nodiscard]] constexpr PixelFormat smallestFormat(bool grey, bool alpha) {
    if (grey)
        return alpha ? PixelFormat::LuminanceAlpha8 : PixelFormat::Luminance8;
    return alpha ? PixelFormat::Rgba8 : PixelFormat::Rgb8;
}

template<class Change> ///< change(components, index of the texel) -> components
[[nodiscard]] Image eachTexel(const Image& image, PixelFormat format, Change change) {
    Image made = Image::uninitialised(format, image.width, image.height, image.depth);
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    const auto madeStep = static_cast<std::size_t>(bytesPerPixel(format));
    const std::size_t texels = image.pixels.size() / step;
    for (std::size_t i = 0; i < texels; ++i)
        storeTexel(format, change(rgbaOf(image.format, image.pixels.data() + i * step), i),
                   made.pixels.data() + i * madeStep);
    return made;
}

} // namespace texplorer
