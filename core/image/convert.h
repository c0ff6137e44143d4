#pragma once

#include "texplorer/image/depth_pixels.h"
#include "texplorer/image/float_pixels.h"
#include "texplorer/image/image.h"

#include <array>

namespace texplorer {

/// A pixel as OpenGL sees it (OpenGL 2.1, table 3.6): missing colours are 0, a missing alpha is 255,
/// luminance is copied to all three colours. A depth is a grey; floats are limited to 0 … 1.
[[nodiscard]] inline std::array<std::uint8_t, 4> rgbaOf(PixelFormat format, const std::byte* pixel) {
    const auto value = [pixel](int i) { return std::to_integer<std::uint8_t>(pixel[i]); };
    switch (format) {
    case PixelFormat::Alpha8:
        return {0, 0, 0, value(0)};
    case PixelFormat::Luminance8:
        return {value(0), value(0), value(0), 255};
    case PixelFormat::LuminanceAlpha8:
        return {value(0), value(0), value(0), value(1)};
    case PixelFormat::Rgb8:
        return {value(0), value(1), value(2), 255};
    case PixelFormat::Rgba8:
        break;
    case PixelFormat::Depth32: {
        const auto grey = static_cast<std::uint8_t>(greyOfDepth(depthAt(pixel)));
        return {grey, grey, grey, 255};
    }
    case PixelFormat::RgbaFloat:
        return bytesOfFloats(floatsAt(pixel));
    }
    return {value(0), value(1), value(2), value(3)};
}

/// Returns all pixels as Rgba8, as OpenGL sees them.
[[nodiscard]] Image asRgba(Image image);

/// Converts what files cannot store: depths to Luminance8, floats to Rgba8. Images of other formats are
/// returned unchanged.
[[nodiscard]] Image asBytes(Image image);

/// Returns the colours of an Rgba8 image as Rgb8. Images of other formats are returned unchanged.
[[nodiscard]] Image withoutAlpha(Image image);

} // namespace texplorer
