#pragma once

// The internal formats of glTexImage: they define the components of a texture, their bits, and what the
// numbers mean.

#include "texplorer/gl/format_facts.h"

namespace texplorer {

/// The heading of its group in a list.
[[nodiscard]] constexpr std::string_view groupOf(InternalFormat format) {
    const FormatFacts& facts = factsOf(format);
    if (isGenericCompressed(format))
        return N_("Compressed");
    switch (facts.encoding) {
    case Encoding::Srgb:
        return "sRGB";
    case Encoding::Depth:
        return N_("Depths");
    case Encoding::Float:
        return N_("Floats");
    case Encoding::None:
        return N_("Mistakes");
    case Encoding::Linear:
        break;
    }
    if (facts.sized != format)
        return format <= InternalFormat::Components4 ? N_("Components") : N_("Base formats");
    if (hasFewBits(format))
        return N_("Few bits");
    return std::ranges::max(facts.bits) > 8 ? N_("Many bits") : N_("8 bits");
}

inline constexpr auto internalFormatRows = [] {
    using enum InternalFormat;
    constexpr std::string_view eightBits =
        N_("Eight bits for each component. Without the number in its name, a driver may choose fewer.");
    constexpr std::string_view twelveBits =
        N_("12 bits for each component: finer steps than an image of 8 bits has. Drivers may store 16.");
    constexpr std::string_view sixteenBits =
        N_("16 bits for each component: finer steps than an image of 8 bits has.");
    constexpr std::string_view anyBits =
        N_("sRGB colours become amounts of light before filtering. The driver chooses the number of bits.");
    constexpr std::string_view compressed =
        N_("The driver compresses to a format of its choice, or doesn't. That takes time and quality.");
    constexpr std::string_view floats = N_(
        "32-bit floats: texels may be below 0 and above 1, which scale, bias and GL_FLOAT in memory make.");
    constexpr std::string_view halves =
        N_("16-bit floats of 11 significant bits, up to 65504: half the memory of 32-bit floats.");
    constexpr std::string_view floatsSince = "GL_ARB_texture_float";
    constexpr std::string_view order =
        N_("An order of components in memory, for the argument format. As an internal format it is "
           "GL_INVALID_VALUE.");
    std::array rows{
        rowOf(BaseFormat::Rgba),
        rowOf(BaseFormat::Rgb),
        rowOf(BaseFormat::Luminance),
        rowOf(BaseFormat::LuminanceAlpha),
        rowOf(BaseFormat::Intensity),
        rowOf(BaseFormat::Alpha),
        row(Components4, "4", "4 components",
            "The same as GL_RGBA: OpenGL 1.0 was told the number of components.", "1.0"),
        row(Components3, "3", "3 components", "The same as GL_RGB.", "1.0"),
        row(Components2, "2", "2 components", "The same as GL_LUMINANCE_ALPHA.", "1.0"),
        row(Components1, "1", "1 component", "The same as GL_LUMINANCE: a grey, not red.", "1.0"),
        row(Rgba8, "GL_RGBA8", "RGBA8", eightBits, "1.1"),
        row(Rgb8, "GL_RGB8", "RGB8", eightBits, "1.1"),
        row(Luminance8, "GL_LUMINANCE8", "Luminance 8", eightBits, "1.1"),
        row(Luminance8Alpha8, "GL_LUMINANCE8_ALPHA8", "Luminance 8 + alpha 8", eightBits, "1.1"),
        row(Intensity8, "GL_INTENSITY8", "Intensity 8", eightBits, "1.1"),
        row(Alpha8, "GL_ALPHA8", "Alpha 8", eightBits, "1.1"),
        row(Rgb5A1, "GL_RGB5_A1", "RGB5 A1",
            "32 steps for each colour, and alpha either 0 or 1: 16 bits a texel.", "1.1"),
        row(Rgba4, "GL_RGBA4", "RGBA4",
            "16 steps for each component: 16 bits a texel, with bands where a colour changes slowly.", "1.1"),
        row(Rgba2, "GL_RGBA2", "RGBA2", "4 steps for each component: 8 bits a texel.", "1.1"),
        row(Rgb10A2, "GL_RGB10_A2", "RGB10 A2",
            "1024 steps for each colour and 4 for alpha: 32 bits a texel.", "1.1"),
        row(Rgb5, "GL_RGB5", "RGB5", "32 steps for each colour, no alpha.", "1.1"),
        row(Rgb4, "GL_RGB4", "RGB4", "16 steps for each colour, no alpha.", "1.1"),
        row(R3G3B2, "GL_R3_G3_B2", "R3 G3 B2",
            "8 steps for red and green and 4 for blue: 8 bits a texel, with broad bands.", "1.1"),
        row(Luminance4, "GL_LUMINANCE4", "Luminance 4", "16 greys.", "1.1"),
        row(Luminance4Alpha4, "GL_LUMINANCE4_ALPHA4", "Luminance 4 + alpha 4",
            "16 greys and 16 steps of alpha: 8 bits a texel.", "1.1"),
        row(Luminance6Alpha2, "GL_LUMINANCE6_ALPHA2", "Luminance 6 + alpha 2",
            "64 greys and 4 steps of alpha: 8 bits a texel.", "1.1"),
        row(Luminance12Alpha4, "GL_LUMINANCE12_ALPHA4", "Luminance 12 + alpha 4",
            "4096 greys and 16 steps of alpha: 16 bits a texel.", "1.1"),
        row(Intensity4, "GL_INTENSITY4", "Intensity 4", "16 steps, for colour and alpha alike.", "1.1"),
        row(Alpha4, "GL_ALPHA4", "Alpha 4", "16 steps of alpha, no colour.", "1.1"),
        row(Rgba16, "GL_RGBA16", "RGBA16", sixteenBits, "1.1"),
        row(Rgba12, "GL_RGBA12", "RGBA12", twelveBits, "1.1"),
        row(Rgb16, "GL_RGB16", "RGB16", sixteenBits, "1.1"),
        row(Rgb12, "GL_RGB12", "RGB12", twelveBits, "1.1"),
        row(Rgb10, "GL_RGB10", "RGB10", "10 bits for each colour: finer steps than an image of 8 bits has.",
            "1.1"),
        row(Luminance16, "GL_LUMINANCE16", "Luminance 16", sixteenBits, "1.1"),
        row(Luminance12, "GL_LUMINANCE12", "Luminance 12", twelveBits, "1.1"),
        row(Luminance16Alpha16, "GL_LUMINANCE16_ALPHA16", "Luminance 16 + alpha 16", sixteenBits, "1.1"),
        row(Luminance12Alpha12, "GL_LUMINANCE12_ALPHA12", "Luminance 12 + alpha 12", twelveBits, "1.1"),
        row(Intensity16, "GL_INTENSITY16", "Intensity 16", sixteenBits, "1.1"),
        row(Intensity12, "GL_INTENSITY12", "Intensity 12", twelveBits, "1.1"),
        row(Alpha16, "GL_ALPHA16", "Alpha 16", sixteenBits, "1.1"),
        row(Alpha12, "GL_ALPHA12", "Alpha 12", twelveBits, "1.1"),
        row(SrgbAlpha, "GL_SRGB_ALPHA", "sRGB + alpha", anyBits, "2.1"),
        row(Srgb, "GL_SRGB", "sRGB", anyBits, "2.1"),
        row(SluminanceAlpha, "GL_SLUMINANCE_ALPHA", "sLuminance + alpha", anyBits, "2.1"),
        row(Sluminance, "GL_SLUMINANCE", "sLuminance", anyBits, "2.1"),
        row(Srgb8Alpha8, "GL_SRGB8_ALPHA8", "sRGB8 A8",
            "The image's colours are sRGB, as in most files, and are converted to amounts of light before "
            "filtering. Alpha is unchanged.",
            "2.1"),
        row(Srgb8, "GL_SRGB8", "sRGB8", "sRGB colours without alpha.", "2.1"),
        row(Sluminance8Alpha8, "GL_SLUMINANCE8_ALPHA8", "sLuminance 8 + alpha 8",
            "An sRGB grey, and alpha unchanged.", "2.1"),
        row(Sluminance8, "GL_SLUMINANCE8", "sLuminance 8", "An sRGB grey without alpha.", "2.1"),
        row(DepthComponent, "GL_DEPTH_COMPONENT", "Depth",
            "The image's red is a distance. The driver chooses the number of bits, as a rule 24.", "1.4"),
        row(DepthComponent16, "GL_DEPTH_COMPONENT16", "Depth, 16 bits",
            "The image's red is a distance, from 0 (near) to 1 (far), in 65536 steps.", "1.4"),
        row(DepthComponent24, "GL_DEPTH_COMPONENT24", "Depth, 24 bits",
            "The image's red is a distance, from 0 (near) to 1 (far), in about 16.8 million steps.", "1.4"),
        row(DepthComponent32, "GL_DEPTH_COMPONENT32", "Depth, 32 bits",
            "The image's red is a distance, from 0 (near) to 1 (far), in about 4.3 billion steps.", "1.4"),
        row(Rgba32F, "GL_RGBA32F_ARB", "RGBA32F", floats, floatsSince),
        row(Rgb32F, "GL_RGB32F_ARB", "RGB32F", floats, floatsSince),
        row(Luminance32F, "GL_LUMINANCE32F_ARB", "Luminance 32F", floats, floatsSince),
        row(LuminanceAlpha32F, "GL_LUMINANCE_ALPHA32F_ARB", "Luminance + alpha 32F", floats, floatsSince),
        row(Intensity32F, "GL_INTENSITY32F_ARB", "Intensity 32F", floats, floatsSince),
        row(Alpha32F, "GL_ALPHA32F_ARB", "Alpha 32F", floats, floatsSince),
        row(Rgba16F, "GL_RGBA16F_ARB", "RGBA16F", halves, floatsSince),
        row(Rgb16F, "GL_RGB16F_ARB", "RGB16F", halves, floatsSince),
        row(Luminance16F, "GL_LUMINANCE16F_ARB", "Luminance 16F", halves, floatsSince),
        row(LuminanceAlpha16F, "GL_LUMINANCE_ALPHA16F_ARB", "Luminance + alpha 16F", halves, floatsSince),
        row(Intensity16F, "GL_INTENSITY16F_ARB", "Intensity 16F", halves, floatsSince),
        row(Alpha16F, "GL_ALPHA16F_ARB", "Alpha 16F", halves, floatsSince),
        row(CompressedRgba, "GL_COMPRESSED_RGBA", "Compressed RGBA", compressed, "1.3"),
        row(CompressedRgb, "GL_COMPRESSED_RGB", "Compressed RGB", compressed, "1.3"),
        row(CompressedLuminance, "GL_COMPRESSED_LUMINANCE", "Compressed luminance", compressed, "1.3"),
        row(CompressedLuminanceAlpha, "GL_COMPRESSED_LUMINANCE_ALPHA", "Compressed lum. + alpha", compressed,
            "1.3"),
        row(CompressedIntensity, "GL_COMPRESSED_INTENSITY", "Compressed intensity", compressed, "1.3"),
        row(CompressedAlpha, "GL_COMPRESSED_ALPHA", "Compressed alpha", compressed, "1.3"),
        row(CompressedSrgbAlpha, "GL_COMPRESSED_SRGB_ALPHA", "Compressed sRGB + alpha", compressed, "2.1"),
        row(CompressedSrgb, "GL_COMPRESSED_SRGB", "Compressed sRGB", compressed, "2.1"),
        row(CompressedSluminanceAlpha, "GL_COMPRESSED_SLUMINANCE_ALPHA", "Compressed sLum. + alpha",
            compressed, "2.1"),
        row(CompressedSluminance, "GL_COMPRESSED_SLUMINANCE", "Compressed sLuminance", compressed, "2.1"),
        row(Bgr, "GL_BGR", "BGR", order),
        row(Bgra, "GL_BGRA", "BGRA", order),
        row(UnsignedByte, "GL_UNSIGNED_BYTE", "Unsigned byte",
            "A type of numbers in memory, for the argument type. As an internal format it is GL_INVALID_VALUE."),
        row(Components0, "0", "0 components",
            "A forgotten value: OpenGL takes 1 to 4 components, and 0 is GL_INVALID_VALUE."),
        row(Components5, "5", "5 components", "OpenGL takes 1 to 4 components: 5 is GL_INVALID_VALUE."),
    };
    for (EnumRow& each : rows) {
        each.group = groupOf(static_cast<InternalFormat>(each.value));
        if (each.since == "1.0" && each.name.starts_with("GL_")) // as internal formats
            each.since = "1.1";
    }
    return rows;
}();

template<>
struct EnumTable<InternalFormat> {
    static constexpr std::span<const EnumRow> rows = internalFormatRows;
};

static_assert(internalFormatRows.size() == 81 && formatFacts.size() == internalFormatRows.size());

} // namespace texplorer
