#pragma once

// What internal formats store: OpenGL 2.1, section 3.8.1, tables 3.15 and 3.16, and GL_ARB_texture_float.
// Their names are in internal_format.h.

#include "texplorer/gl/environment.h"

namespace texplorer {

enum class InternalFormat : std::uint32_t {
    Components1 = 1, ///< OpenGL 1.0's names
    Components2 = 2,
    Components3 = 3,
    Components4 = 4,
    Alpha = static_cast<std::uint32_t>(BaseFormat::Alpha),
    Luminance = static_cast<std::uint32_t>(BaseFormat::Luminance),
    LuminanceAlpha = static_cast<std::uint32_t>(BaseFormat::LuminanceAlpha),
    Intensity = static_cast<std::uint32_t>(BaseFormat::Intensity),
    Rgb = static_cast<std::uint32_t>(BaseFormat::Rgb),
    Rgba = static_cast<std::uint32_t>(BaseFormat::Rgba),
    Alpha4 = 0x803B,
    Alpha8 = 0x803C,
    Alpha12 = 0x803D,
    Alpha16 = 0x803E,
    Luminance4 = 0x803F,
    Luminance8 = 0x8040,
    Luminance12 = 0x8041,
    Luminance16 = 0x8042,
    Luminance4Alpha4 = 0x8043,
    Luminance6Alpha2 = 0x8044,
    Luminance8Alpha8 = 0x8045,
    Luminance12Alpha4 = 0x8046,
    Luminance12Alpha12 = 0x8047,
    Luminance16Alpha16 = 0x8048,
    Intensity4 = 0x804A,
    Intensity8 = 0x804B,
    Intensity12 = 0x804C,
    Intensity16 = 0x804D,
    R3G3B2 = 0x2A10,
    Rgb4 = 0x804F,
    Rgb5 = 0x8050,
    Rgb8 = 0x8051,
    Rgb10 = 0x8052,
    Rgb12 = 0x8053,
    Rgb16 = 0x8054,
    Rgba2 = 0x8055,
    Rgba4 = 0x8056,
    Rgb5A1 = 0x8057,
    Rgba8 = 0x8058,
    Rgb10A2 = 0x8059,
    Rgba12 = 0x805A,
    Rgba16 = 0x805B,
    Srgb = 0x8C40,
    Srgb8 = 0x8C41,
    SrgbAlpha = 0x8C42,
    Srgb8Alpha8 = 0x8C43,
    SluminanceAlpha = 0x8C44,
    Sluminance8Alpha8 = 0x8C45,
    Sluminance = 0x8C46,
    Sluminance8 = 0x8C47,
    DepthComponent = 0x1902,
    DepthComponent16 = 0x81A5,
    DepthComponent24 = 0x81A6,
    DepthComponent32 = 0x81A7,
    CompressedAlpha = 0x84E9,
    CompressedLuminance = 0x84EA,
    CompressedLuminanceAlpha = 0x84EB,
    CompressedIntensity = 0x84EC,
    CompressedRgb = 0x84ED,
    CompressedRgba = 0x84EE,
    CompressedSrgb = 0x8C48,
    CompressedSrgbAlpha = 0x8C49,
    CompressedSluminance = 0x8C4A,
    CompressedSluminanceAlpha = 0x8C4B,
    Rgba32F = 0x8814, ///< GL_ARB_texture_float
    Rgb32F = 0x8815,
    Alpha32F = 0x8816,
    Intensity32F = 0x8817,
    Luminance32F = 0x8818,
    LuminanceAlpha32F = 0x8819,
    Rgba16F = 0x881A,
    Rgb16F = 0x881B,
    Alpha16F = 0x881C,
    Intensity16F = 0x881D,
    Luminance16F = 0x881E,
    LuminanceAlpha16F = 0x881F,
    Components0 = 0, ///< like the rest, what programs ask for by mistake
    Components5 = 5,
    Bgr = 0x80E0,
    Bgra = 0x80E1,
    UnsignedByte = 0x1401,
};

/// What the numbers of a texel mean.
enum class Encoding : std::uint8_t {
    Linear,
    Srgb, ///< colours on sRGB's curve, converted to linear before filtering; alpha is linear
    Depth,
    Float, ///< any number, not 0 to 1 alone
    None,  ///< OpenGL has no such format
};

/// What a texture stores of an image. Where OpenGL leaves the number of bits to the driver (GL_RGBA), there
/// are eight, of depths 24.
struct FormatFacts {
    InternalFormat format;
    BaseFormat base;                  ///< of depth textures, GL_DEPTH_TEXTURE_MODE is used instead
    std::array<std::uint8_t, 4> bits; ///< of red (luminance, intensity or depth), green, blue and alpha
    Encoding encoding = Encoding::Linear;
    /// The format that has these bits in its name: for another, drivers may store fewer if an image has
    /// fewer.
    InternalFormat sized = format;
};

inline constexpr auto formatFacts = [] {
    using enum InternalFormat;
    using Base = BaseFormat;
    return std::array{
        FormatFacts{Rgba, Base::Rgba, {8, 8, 8, 8}, Encoding::Linear, Rgba8},
        FormatFacts{Rgb, Base::Rgb, {8, 8, 8, 0}, Encoding::Linear, Rgb8},
        FormatFacts{Luminance, Base::Luminance, {8, 0, 0, 0}, Encoding::Linear, Luminance8},
        FormatFacts{LuminanceAlpha, Base::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Linear, Luminance8Alpha8},
        FormatFacts{Intensity, Base::Intensity, {8, 0, 0, 0}, Encoding::Linear, Intensity8},
        FormatFacts{Alpha, Base::Alpha, {0, 0, 0, 8}, Encoding::Linear, Alpha8},
        FormatFacts{Components4, Base::Rgba, {8, 8, 8, 8}, Encoding::Linear, Rgba8},
        FormatFacts{Components3, Base::Rgb, {8, 8, 8, 0}, Encoding::Linear, Rgb8},
        FormatFacts{Components2, Base::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Linear, Luminance8Alpha8},
        FormatFacts{Components1, Base::Luminance, {8, 0, 0, 0}, Encoding::Linear, Luminance8},
        FormatFacts{Rgba8, Base::Rgba, {8, 8, 8, 8}},
        FormatFacts{Rgb8, Base::Rgb, {8, 8, 8, 0}},
        FormatFacts{Luminance8, Base::Luminance, {8, 0, 0, 0}},
        FormatFacts{Luminance8Alpha8, Base::LuminanceAlpha, {8, 0, 0, 8}},
        FormatFacts{Intensity8, Base::Intensity, {8, 0, 0, 0}},
        FormatFacts{Alpha8, Base::Alpha, {0, 0, 0, 8}},
        FormatFacts{Rgb5A1, Base::Rgba, {5, 5, 5, 1}},
        FormatFacts{Rgba4, Base::Rgba, {4, 4, 4, 4}},
        FormatFacts{Rgba2, Base::Rgba, {2, 2, 2, 2}},
        FormatFacts{Rgb10A2, Base::Rgba, {10, 10, 10, 2}},
        FormatFacts{Rgb5, Base::Rgb, {5, 5, 5, 0}},
        FormatFacts{Rgb4, Base::Rgb, {4, 4, 4, 0}},
        FormatFacts{R3G3B2, Base::Rgb, {3, 3, 2, 0}},
        FormatFacts{Luminance4, Base::Luminance, {4, 0, 0, 0}},
        FormatFacts{Luminance4Alpha4, Base::LuminanceAlpha, {4, 0, 0, 4}},
        FormatFacts{Luminance6Alpha2, Base::LuminanceAlpha, {6, 0, 0, 2}},
        FormatFacts{Luminance12Alpha4, Base::LuminanceAlpha, {12, 0, 0, 4}},
        FormatFacts{Intensity4, Base::Intensity, {4, 0, 0, 0}},
        FormatFacts{Alpha4, Base::Alpha, {0, 0, 0, 4}},
        FormatFacts{Rgba16, Base::Rgba, {16, 16, 16, 16}},
        FormatFacts{Rgba12, Base::Rgba, {12, 12, 12, 12}},
        FormatFacts{Rgb16, Base::Rgb, {16, 16, 16, 0}},
        FormatFacts{Rgb12, Base::Rgb, {12, 12, 12, 0}},
        FormatFacts{Rgb10, Base::Rgb, {10, 10, 10, 0}},
        FormatFacts{Luminance16, Base::Luminance, {16, 0, 0, 0}},
        FormatFacts{Luminance12, Base::Luminance, {12, 0, 0, 0}},
        FormatFacts{Luminance16Alpha16, Base::LuminanceAlpha, {16, 0, 0, 16}},
        FormatFacts{Luminance12Alpha12, Base::LuminanceAlpha, {12, 0, 0, 12}},
        FormatFacts{Intensity16, Base::Intensity, {16, 0, 0, 0}},
        FormatFacts{Intensity12, Base::Intensity, {12, 0, 0, 0}},
        FormatFacts{Alpha16, Base::Alpha, {0, 0, 0, 16}},
        FormatFacts{Alpha12, Base::Alpha, {0, 0, 0, 12}},
        FormatFacts{SrgbAlpha, Base::Rgba, {8, 8, 8, 8}, Encoding::Srgb, Srgb8Alpha8},
        FormatFacts{Srgb, Base::Rgb, {8, 8, 8, 0}, Encoding::Srgb, Srgb8},
        FormatFacts{SluminanceAlpha, Base::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Srgb, Sluminance8Alpha8},
        FormatFacts{Sluminance, Base::Luminance, {8, 0, 0, 0}, Encoding::Srgb, Sluminance8},
        FormatFacts{Srgb8Alpha8, Base::Rgba, {8, 8, 8, 8}, Encoding::Srgb},
        FormatFacts{Srgb8, Base::Rgb, {8, 8, 8, 0}, Encoding::Srgb},
        FormatFacts{Sluminance8Alpha8, Base::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Srgb},
        FormatFacts{Sluminance8, Base::Luminance, {8, 0, 0, 0}, Encoding::Srgb},
        FormatFacts{DepthComponent, Base::Luminance, {24, 0, 0, 0}, Encoding::Depth, DepthComponent24},
        FormatFacts{DepthComponent16, Base::Luminance, {16, 0, 0, 0}, Encoding::Depth},
        FormatFacts{DepthComponent24, Base::Luminance, {24, 0, 0, 0}, Encoding::Depth},
        FormatFacts{DepthComponent32, Base::Luminance, {32, 0, 0, 0}, Encoding::Depth},
        FormatFacts{Rgba32F, Base::Rgba, {32, 32, 32, 32}, Encoding::Float},
        FormatFacts{Rgb32F, Base::Rgb, {32, 32, 32, 0}, Encoding::Float},
        FormatFacts{Luminance32F, Base::Luminance, {32, 0, 0, 0}, Encoding::Float},
        FormatFacts{LuminanceAlpha32F, Base::LuminanceAlpha, {32, 0, 0, 32}, Encoding::Float},
        FormatFacts{Intensity32F, Base::Intensity, {32, 0, 0, 0}, Encoding::Float},
        FormatFacts{Alpha32F, Base::Alpha, {0, 0, 0, 32}, Encoding::Float},
        FormatFacts{Rgba16F, Base::Rgba, {16, 16, 16, 16}, Encoding::Float},
        FormatFacts{Rgb16F, Base::Rgb, {16, 16, 16, 0}, Encoding::Float},
        FormatFacts{Luminance16F, Base::Luminance, {16, 0, 0, 0}, Encoding::Float},
        FormatFacts{LuminanceAlpha16F, Base::LuminanceAlpha, {16, 0, 0, 16}, Encoding::Float},
        FormatFacts{Intensity16F, Base::Intensity, {16, 0, 0, 0}, Encoding::Float},
        FormatFacts{Alpha16F, Base::Alpha, {0, 0, 0, 16}, Encoding::Float},
        FormatFacts{CompressedRgba, Base::Rgba, {8, 8, 8, 8}},
        FormatFacts{CompressedRgb, Base::Rgb, {8, 8, 8, 0}},
        FormatFacts{CompressedLuminance, Base::Luminance, {8, 0, 0, 0}},
        FormatFacts{CompressedLuminanceAlpha, Base::LuminanceAlpha, {8, 0, 0, 8}},
        FormatFacts{CompressedIntensity, Base::Intensity, {8, 0, 0, 0}},
        FormatFacts{CompressedAlpha, Base::Alpha, {0, 0, 0, 8}},
        FormatFacts{CompressedSrgbAlpha, Base::Rgba, {8, 8, 8, 8}, Encoding::Srgb},
        FormatFacts{CompressedSrgb, Base::Rgb, {8, 8, 8, 0}, Encoding::Srgb},
        FormatFacts{CompressedSluminanceAlpha, Base::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Srgb},
        FormatFacts{CompressedSluminance, Base::Luminance, {8, 0, 0, 0}, Encoding::Srgb},
        FormatFacts{Bgr, Base::Rgb, {0, 0, 0, 0}, Encoding::None},
        FormatFacts{Bgra, Base::Rgba, {0, 0, 0, 0}, Encoding::None},
        FormatFacts{UnsignedByte, Base::Rgba, {0, 0, 0, 0}, Encoding::None},
        FormatFacts{Components0, Base::Rgba, {0, 0, 0, 0}, Encoding::None},
        FormatFacts{Components5, Base::Rgba, {0, 0, 0, 0}, Encoding::None},
    };
}();

[[nodiscard]] constexpr const FormatFacts& factsOf(InternalFormat format) {
    const auto* found = std::ranges::find(formatFacts, format, &FormatFacts::format);
    return found == formatFacts.end() ? formatFacts.front() : *found;
}
[[nodiscard]] constexpr BaseFormat baseFormat(InternalFormat format) {
    return factsOf(format).base;
}
/// Whether it stores fewer bits of a component than images have.
[[nodiscard]] constexpr bool hasFewBits(InternalFormat format) {
    return std::ranges::any_of(factsOf(format).bits, [](int bits) { return bits > 0 && bits < 8; });
}
/// According to its name, in whole bytes; a driver may use more.
[[nodiscard]] constexpr int bytesPerTexel(InternalFormat format) {
    int bits = 0;
    for (const int each : factsOf(format).bits)
        bits += each;
    return (bits + 7) / 8;
}
[[nodiscard]] constexpr bool isDepth(InternalFormat format) { // called for every sample
    return format == InternalFormat::DepthComponent ||
           (format >= InternalFormat::DepthComponent16 && format <= InternalFormat::DepthComponent32);
}
[[nodiscard]] constexpr bool isSrgb(InternalFormat format) {
    return factsOf(format).encoding == Encoding::Srgb;
}
/// Whether texels may be any numbers (GL_ARB_texture_float).
[[nodiscard]] constexpr bool isFloat(InternalFormat format) {
    return factsOf(format).encoding == Encoding::Float;
}
/// The bits of its widest component.
[[nodiscard]] constexpr int mostBits(InternalFormat format) {
    return std::ranges::max(factsOf(format).bits);
}
/// Whether the driver chooses a compressed format for it, or none.
[[nodiscard]] constexpr bool isGenericCompressed(InternalFormat format) {
    return (format >= InternalFormat::CompressedAlpha && format <= InternalFormat::CompressedRgba) ||
           (format >= InternalFormat::CompressedSrgb && format <= InternalFormat::CompressedSluminanceAlpha);
}
/// Whether glTexImage is GL_INVALID_VALUE and defines no image.
[[nodiscard]] constexpr bool isRefused(InternalFormat format) {
    return factsOf(format).encoding == Encoding::None;
}
/// The format with 32-bit floats and the same components.
[[nodiscard]] constexpr InternalFormat floatFormat(BaseFormat base) {
    const auto* found = std::ranges::find_if(formatFacts, [base](const FormatFacts& facts) {
        return facts.encoding == Encoding::Float && facts.base == base;
    });
    return found->format;
}
/// The format with eight bits per component that has the name of a base format.
[[nodiscard]] constexpr InternalFormat internalFormat(BaseFormat format) {
    return static_cast<InternalFormat>(format);
}

} // namespace texplorer
