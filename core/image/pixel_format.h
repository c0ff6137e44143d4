#pragma once

#include "texplorer/base/translatable.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace texplorer {

/// Eight bits per component, tightly packed, in this order in memory. Files cannot store the others, which
/// are in the processor's byte order: one depth of 32 bits, 0 to 1 (texplorer/image/depth_pixels.h), or four
/// numbers of any size (texplorer/image/float_pixels.h).
enum class PixelFormat : std::uint8_t {
    Alpha8,
    Luminance8,
    LuminanceAlpha8,
    Rgb8,
    Rgba8,
    Depth32,
    RgbaFloat
};

struct PixelFormatRow {
    PixelFormat format;
    int bytesPerPixel;
    std::string_view name;
};

inline constexpr std::array pixelFormatRows{
    PixelFormatRow{PixelFormat::Alpha8, 1, N_("alpha, 8 bits")},
    PixelFormatRow{PixelFormat::Luminance8, 1, N_("luminance, 8 bits")},
    PixelFormatRow{PixelFormat::LuminanceAlpha8, 2, N_("luminance and alpha, 8 bits each")},
    PixelFormatRow{PixelFormat::Rgb8, 3, N_("RGB, 8 bits each")},
    PixelFormatRow{PixelFormat::Rgba8, 4, N_("RGBA, 8 bits each")},
    PixelFormatRow{PixelFormat::Depth32, 4, N_("depth, 32 bits")},
    PixelFormatRow{PixelFormat::RgbaFloat, 16, N_("RGBA, floats")},
};

/// The formats of files.
inline constexpr std::span<const PixelFormatRow> colorFormatRows = std::span(pixelFormatRows).first(5);

static_assert(pixelFormatRows.size() == 7);

/// The rows are in the order of the enumerators, so a format is its row's index.
[[nodiscard]] constexpr const PixelFormatRow& rowOf(PixelFormat format) {
    return pixelFormatRows[static_cast<std::size_t>(format)];
}

[[nodiscard]] constexpr int bytesPerPixel(PixelFormat format) {
    return rowOf(format).bytesPerPixel;
}

} // namespace texplorer
