#pragma once

// The internal formats of glTexImage: OpenGL 2.1, section 3.8.1, tables 3.15 and 3.16. They define the
// components of a texture, their bits, and what the numbers mean.

#include "texplorer/gl/environment.h"

namespace texplorer {

enum class InternalFormat : std::uint32_t {
    Alpha = static_cast<std::uint32_t>(BaseFormat::Alpha),
    Luminance = static_cast<std::uint32_t>(BaseFormat::Luminance),
    LuminanceAlpha = static_cast<std::uint32_t>(BaseFormat::LuminanceAlpha),
    Intensity = static_cast<std::uint32_t>(BaseFormat::Intensity),
    Rgb = static_cast<std::uint32_t>(BaseFormat::Rgb),
    Rgba = static_cast<std::uint32_t>(BaseFormat::Rgba),
    Alpha4 = 0x803B,
    Luminance4 = 0x803F,
    Luminance4Alpha4 = 0x8043,
    Intensity4 = 0x804A,
    R3G3B2 = 0x2A10,
    Rgb4 = 0x804F,
    Rgb5 = 0x8050,
    Rgba2 = 0x8055,
    Rgba4 = 0x8056,
    Rgb5A1 = 0x8057,
    Srgb8 = 0x8C41,
    Srgb8Alpha8 = 0x8C43,
    Sluminance8 = 0x8C47,
    Sluminance8Alpha8 = 0x8C45,
    DepthComponent16 = 0x81A5,
    DepthComponent24 = 0x81A6,
};

/// What the numbers of a texel mean.
enum class Encoding : std::uint8_t {
    Linear,
    Srgb, ///< colours on sRGB's curve, converted to linear before filtering; alpha is linear
    Depth,
};

/// What a texture stores of an image. Where OpenGL leaves the number of bits to the driver (GL_RGBA), there
/// are eight.
struct FormatFacts {
    InternalFormat format;
    BaseFormat base;                  ///< of depth textures, GL_DEPTH_TEXTURE_MODE is used instead
    std::array<std::uint8_t, 4> bits; ///< of red (luminance, intensity or depth), green, blue and alpha
    Encoding encoding = Encoding::Linear;
};

inline constexpr std::array formatFacts{
    FormatFacts{InternalFormat::Rgba, BaseFormat::Rgba, {8, 8, 8, 8}},
    FormatFacts{InternalFormat::Rgb, BaseFormat::Rgb, {8, 8, 8, 0}},
    FormatFacts{InternalFormat::Luminance, BaseFormat::Luminance, {8, 0, 0, 0}},
    FormatFacts{InternalFormat::LuminanceAlpha, BaseFormat::LuminanceAlpha, {8, 0, 0, 8}},
    FormatFacts{InternalFormat::Intensity, BaseFormat::Intensity, {8, 0, 0, 0}},
    FormatFacts{InternalFormat::Alpha, BaseFormat::Alpha, {0, 0, 0, 8}},
    FormatFacts{InternalFormat::Rgb5A1, BaseFormat::Rgba, {5, 5, 5, 1}},
    FormatFacts{InternalFormat::Rgba4, BaseFormat::Rgba, {4, 4, 4, 4}},
    FormatFacts{InternalFormat::Rgba2, BaseFormat::Rgba, {2, 2, 2, 2}},
    FormatFacts{InternalFormat::Rgb5, BaseFormat::Rgb, {5, 5, 5, 0}},
    FormatFacts{InternalFormat::Rgb4, BaseFormat::Rgb, {4, 4, 4, 0}},
    FormatFacts{InternalFormat::R3G3B2, BaseFormat::Rgb, {3, 3, 2, 0}},
    FormatFacts{InternalFormat::Luminance4, BaseFormat::Luminance, {4, 0, 0, 0}},
    FormatFacts{InternalFormat::Luminance4Alpha4, BaseFormat::LuminanceAlpha, {4, 0, 0, 4}},
    FormatFacts{InternalFormat::Intensity4, BaseFormat::Intensity, {4, 0, 0, 0}},
    FormatFacts{InternalFormat::Alpha4, BaseFormat::Alpha, {0, 0, 0, 4}},
    FormatFacts{InternalFormat::Srgb8Alpha8, BaseFormat::Rgba, {8, 8, 8, 8}, Encoding::Srgb},
    FormatFacts{InternalFormat::Srgb8, BaseFormat::Rgb, {8, 8, 8, 0}, Encoding::Srgb},
    FormatFacts{InternalFormat::Sluminance8Alpha8, BaseFormat::LuminanceAlpha, {8, 0, 0, 8}, Encoding::Srgb},
    FormatFacts{InternalFormat::Sluminance8, BaseFormat::Luminance, {8, 0, 0, 0}, Encoding::Srgb},
    FormatFacts{InternalFormat::DepthComponent16, BaseFormat::Luminance, {16, 0, 0, 0}, Encoding::Depth},
    FormatFacts{InternalFormat::DepthComponent24, BaseFormat::Luminance, {24, 0, 0, 0}, Encoding::Depth},
};

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
    return format == InternalFormat::DepthComponent16 || format == InternalFormat::DepthComponent24;
}
[[nodiscard]] constexpr bool isSrgb(InternalFormat format) {
    return factsOf(format).encoding == Encoding::Srgb;
}
/// The format with eight bits per component that has the name of a base format.
[[nodiscard]] constexpr InternalFormat internalFormat(BaseFormat format) {
    return static_cast<InternalFormat>(format);
}

/// The name with eight bits per component, where the name leaves the number open: drivers may choose fewer if
/// an image has fewer (OpenGL 2.1, section 3.8.1).
[[nodiscard]] constexpr std::string_view sizedNameOf(InternalFormat format) {
    switch (format) {
    case InternalFormat::Alpha:
        return "GL_ALPHA8";
    case InternalFormat::Luminance:
        return "GL_LUMINANCE8";
    case InternalFormat::LuminanceAlpha:
        return "GL_LUMINANCE8_ALPHA8";
    case InternalFormat::Intensity:
        return "GL_INTENSITY8";
    case InternalFormat::Rgb:
        return "GL_RGB8";
    case InternalFormat::Rgba:
        return "GL_RGBA8";
    default:
        return {};
    }
}

/// The heading of its group in a list.
[[nodiscard]] constexpr std::string_view groupOf(InternalFormat format) {
    switch (factsOf(format).encoding) {
    case Encoding::Srgb:
        return "sRGB";
    case Encoding::Depth:
        return N_("Depths");
    case Encoding::Linear:
        break;
    }
    return hasFewBits(format) ? N_("Few bits") : N_("8 bits");
}

inline constexpr auto internalFormatRows = [] {
    std::array rows{
        rowOf(BaseFormat::Rgba),
        rowOf(BaseFormat::Rgb),
        rowOf(BaseFormat::Luminance),
        rowOf(BaseFormat::LuminanceAlpha),
        rowOf(BaseFormat::Intensity),
        rowOf(BaseFormat::Alpha),
        row(InternalFormat::Rgb5A1, "GL_RGB5_A1", "RGB5 A1",
            "32 steps for each colour, and alpha either 0 or 1: 16 bits a texel.", "1.1"),
        row(InternalFormat::Rgba4, "GL_RGBA4", "RGBA4",
            "16 steps for each component: 16 bits a texel, with bands where a colour changes slowly.", "1.1"),
        row(InternalFormat::Rgba2, "GL_RGBA2", "RGBA2", "4 steps for each component: 8 bits a texel.", "1.1"),
        row(InternalFormat::Rgb5, "GL_RGB5", "RGB5", "32 steps for each colour, no alpha.", "1.1"),
        row(InternalFormat::Rgb4, "GL_RGB4", "RGB4", "16 steps for each colour, no alpha.", "1.1"),
        row(InternalFormat::R3G3B2, "GL_R3_G3_B2", "R3 G3 B2",
            "8 steps for red and green and 4 for blue: 8 bits a texel, with broad bands.", "1.1"),
        row(InternalFormat::Luminance4, "GL_LUMINANCE4", "Luminance 4", "16 greys.", "1.1"),
        row(InternalFormat::Luminance4Alpha4, "GL_LUMINANCE4_ALPHA4", "Luminance 4 + alpha 4",
            "16 greys and 16 steps of alpha: 8 bits a texel.", "1.1"),
        row(InternalFormat::Intensity4, "GL_INTENSITY4", "Intensity 4",
            "16 steps, for colour and alpha alike.", "1.1"),
        row(InternalFormat::Alpha4, "GL_ALPHA4", "Alpha 4", "16 steps of alpha, no colour.", "1.1"),
        row(InternalFormat::Srgb8Alpha8, "GL_SRGB8_ALPHA8", "sRGB + alpha",
            "The image's colours are sRGB, as in most files, and are converted to amounts of light before "
            "filtering. Alpha is unchanged.",
            "2.1"),
        row(InternalFormat::Srgb8, "GL_SRGB8", "sRGB", "sRGB colours without alpha.", "2.1"),
        row(InternalFormat::Sluminance8Alpha8, "GL_SLUMINANCE8_ALPHA8", "sLuminance + alpha",
            "An sRGB grey, and alpha unchanged.", "2.1"),
        row(InternalFormat::Sluminance8, "GL_SLUMINANCE8", "sLuminance", "An sRGB grey without alpha.",
            "2.1"),
        row(InternalFormat::DepthComponent16, "GL_DEPTH_COMPONENT16", "Depth, 16 bits",
            "The image's red is a distance, from 0 (near) to 1 (far), in 65536 steps.", "1.4"),
        row(InternalFormat::DepthComponent24, "GL_DEPTH_COMPONENT24", "Depth, 24 bits",
            "The image's red is a distance, from 0 (near) to 1 (far), in about 16.8 million steps.", "1.4"),
    };
    for (EnumRow& each : rows)
        each.group = groupOf(static_cast<InternalFormat>(each.value));
    return rows;
}();

template<>
struct EnumTable<InternalFormat> {
    static constexpr std::span<const EnumRow> rows = internalFormatRows;
};

static_assert(internalFormatRows.size() == 22 && formatFacts.size() == internalFormatRows.size());

} // namespace texplorer
