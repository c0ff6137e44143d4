#pragma once

// What a texture unit does with the filtered colour: OpenGL 2.1, section 3.8.13, tables 3.21 and 3.22. The
// parameters of GL_COMBINE are in combine.h.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class EnvMode : std::uint32_t {
    Replace = 0x1E01,
    Modulate = 0x2100,
    Decal = 0x2101,
    Blend = 0x0BE2,
    Add = 0x0104,
    Combine = 0x8570,
};

/// The six base internal formats of section 3.8.1, which define the components of a texture.
enum class BaseFormat : std::uint32_t {
    Alpha = 0x1906,
    Luminance = 0x1909,
    LuminanceAlpha = 0x190A,
    Intensity = 0x8049,
    Rgb = 0x1907,
    Rgba = 0x1908,
};

inline constexpr std::array envModeRows{
    row(EnvMode::Modulate, "GL_MODULATE", "Modulate",
        "Fragment colour times texture colour: lighting shows through. GL's initial value.", "1.0"),
    row(EnvMode::Replace, "GL_REPLACE", "Replace",
        "The texture's colour alone. Lighting and glColor have "
        "no effect.",
        "1.1"),
    row(EnvMode::Decal, "GL_DECAL", "Decal",
        "Paints the texture over the fragment by the texture's alpha. Defined only for RGB and RGBA.", "1.0"),
    row(EnvMode::Blend, "GL_BLEND", "Blend",
        "The texture mixes between the fragment colour (0) and the environment colour (1).", "1.0"),
    row(EnvMode::Add, "GL_ADD", "Add",
        "Fragment colour plus texture colour, clamped to 1; alpha is multiplied, except for INTENSITY.",
        "1.3"),
    row(EnvMode::Combine, "GL_COMBINE", "Combine",
        "A selectable function of up to three arguments, separately for colour and alpha.", "1.3"),
};

inline constexpr std::array baseFormatRows{
    row(BaseFormat::Rgba, "GL_RGBA", "RGBA", "Colour and alpha from the image.", "1.0"),
    row(BaseFormat::Rgb, "GL_RGB", "RGB",
        "Colour from the image. The texture has no alpha, which counts "
        "as 1.",
        "1.0"),
    row(BaseFormat::Luminance, "GL_LUMINANCE", "Luminance",
        "The image's red is used for red, green and blue (grey). No alpha.", "1.0"),
    row(BaseFormat::LuminanceAlpha, "GL_LUMINANCE_ALPHA", "Luminance + alpha",
        "Grey from the image's red, and the image's alpha.", "1.0"),
    row(BaseFormat::Intensity, "GL_INTENSITY", "Intensity",
        "The image's red is used for all four components, including alpha.", "1.1"),
    row(BaseFormat::Alpha, "GL_ALPHA", "Alpha", "The image's alpha only. The fragment's colour is unchanged.",
        "1.0"),
};

template<>
struct EnumTable<EnvMode> {
    static constexpr std::span<const EnumRow> rows = envModeRows;
};
template<>
struct EnumTable<BaseFormat> {
    static constexpr std::span<const EnumRow> rows = baseFormatRows;
};

static_assert(envModeRows.size() == 6 && baseFormatRows.size() == 6);

} // namespace texplorer
