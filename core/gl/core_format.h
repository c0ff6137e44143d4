#pragma once

#include "texplorer/gl/internal_format.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace texplorer {

/// An internal format of OpenGL 3.3's core profile, which has formats of red, of two, three and four
/// components, and of depths. Texels are given as RGBA; the red of a luminance is used.
struct CoreFormat {
    InternalFormat format;
    std::string_view name;
    std::string_view swizzle{}; ///< of GL_TEXTURE_SWIZZLE_RGBA; empty: none
};

inline constexpr std::string_view alphaSwizzle = "GL_ZERO, GL_ZERO, GL_ZERO, GL_ALPHA";
inline constexpr std::string_view luminanceSwizzle = "GL_RED, GL_RED, GL_RED, GL_ONE";
inline constexpr std::string_view luminanceAlphaSwizzle = "GL_RED, GL_RED, GL_RED, GL_ALPHA";
inline constexpr std::string_view intensitySwizzle = "GL_RED, GL_RED, GL_RED, GL_RED";

inline constexpr std::array coreFormats{
    CoreFormat{InternalFormat::Rgba, "GL_RGBA8"},
    CoreFormat{InternalFormat::Rgb, "GL_RGB8"},
    CoreFormat{InternalFormat::Alpha, "GL_RGBA8", alphaSwizzle},
    CoreFormat{InternalFormat::Alpha4, "GL_RGBA8", alphaSwizzle},
    CoreFormat{InternalFormat::Luminance, "GL_R8", luminanceSwizzle},
    CoreFormat{InternalFormat::Luminance4, "GL_R8", luminanceSwizzle},
    CoreFormat{InternalFormat::LuminanceAlpha, "GL_RGBA8", luminanceAlphaSwizzle},
    CoreFormat{InternalFormat::Luminance4Alpha4, "GL_RGBA8", luminanceAlphaSwizzle},
    CoreFormat{InternalFormat::Intensity, "GL_R8", intensitySwizzle},
    CoreFormat{InternalFormat::Intensity4, "GL_R8", intensitySwizzle},
    CoreFormat{InternalFormat::Sluminance8, "GL_SRGB8", luminanceSwizzle},
    CoreFormat{InternalFormat::Sluminance8Alpha8, "GL_SRGB8_ALPHA8", luminanceAlphaSwizzle},
};

/// Formats that exist in both keep their name.
[[nodiscard]] constexpr CoreFormat coreFormatOf(InternalFormat format) {
    const auto* found = std::ranges::find(coreFormats, format, &CoreFormat::format);
    return found == coreFormats.end() ? CoreFormat{format, rowOf(format).name} : *found;
}

} // namespace texplorer
