#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace texplorer {

/// Eight bits a component, tightly packed, in this order in memory.
enum class PixelFormat : std::uint8_t { Alpha8, Luminance8, LuminanceAlpha8, Rgb8, Rgba8 };

struct PixelFormatRow {
    PixelFormat format;
    int bytesPerPixel;
    std::string_view name;
};

inline constexpr std::array pixelFormatRows{
    PixelFormatRow{PixelFormat::Alpha8, 1, "alpha, 8 bits"},
    PixelFormatRow{PixelFormat::Luminance8, 1, "luminance, 8 bits"},
    PixelFormatRow{PixelFormat::LuminanceAlpha8, 2, "luminance and alpha, 8 bits each"},
    PixelFormatRow{PixelFormat::Rgb8, 3, "RGB, 8 bits each"},
    PixelFormatRow{PixelFormat::Rgba8, 4, "RGBA, 8 bits each"},
};

static_assert(pixelFormatRows.size() == 5);

/// The rows stand in the order of the enumerators, so a format is its row's index.
[[nodiscard]] constexpr const PixelFormatRow& rowOf(PixelFormat format) {
    return pixelFormatRows[static_cast<std::size_t>(format)];
}

[[nodiscard]] constexpr int bytesPerPixel(PixelFormat format) {
    return rowOf(format).bytesPerPixel;
}

} // namespace texplorer
