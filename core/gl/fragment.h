#pragma once

// Shading and the per-fragment operations: OpenGL 2.1, sections 2.14 and 4.1.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class ShadeModel : std::uint32_t { Flat = 0x1D00, Smooth = 0x1D01 };
enum class ColorControl : std::uint32_t { Single = 0x81F9, SeparateSpecular = 0x81FA };

enum class CompareFunc : std::uint32_t {
    Never = 0x0200,
    Less = 0x0201,
    Equal = 0x0202,
    LessEqual = 0x0203,
    Greater = 0x0204,
    NotEqual = 0x0205,
    GreaterEqual = 0x0206,
    Always = 0x0207,
};

enum class BlendFactor : std::uint32_t {
    Zero = 0,
    One = 1,
    SrcColor = 0x0300,
    OneMinusSrcColor = 0x0301,
    SrcAlpha = 0x0302,
    OneMinusSrcAlpha = 0x0303,
    DstAlpha = 0x0304,
    OneMinusDstAlpha = 0x0305,
    DstColor = 0x0306,
    OneMinusDstColor = 0x0307,
};

inline constexpr std::array shadeModelRows{
    row(ShadeModel::Smooth, "GL_SMOOTH", "Smooth", "Colours are interpolated between the vertices.", "1.0"),
    row(ShadeModel::Flat, "GL_FLAT", "Flat", "Each triangle has the colour of its last vertex.", "1.0"),
};

inline constexpr std::array colorControlRows{
    row(ColorControl::Single, "GL_SINGLE_COLOR", "Single colour",
        "The highlight is added before texturing, so the texture dims it.", "1.2"),
    row(ColorControl::SeparateSpecular, "GL_SEPARATE_SPECULAR_COLOR", "Separate specular",
        "The highlight is added after texturing, so it stays bright on dark texels.", "1.2"),
};

inline constexpr std::array compareFuncRows{
    row(CompareFunc::Never, "GL_NEVER", "Never", "Nothing passes.", "1.0"),
    row(CompareFunc::Less, "GL_LESS", "Less", "Passes if the new value is below the reference.", "1.0"),
    row(CompareFunc::Equal, "GL_EQUAL", "Equal",
        "Passes if both are equal. A second pass draws over the first one this way.", "1.0"),
    row(CompareFunc::LessEqual, "GL_LEQUAL", "Less or equal",
        "Passes if the new value is not above the reference.", "1.0"),
    row(CompareFunc::Greater, "GL_GREATER", "Greater", "Passes if the new value is above the reference.",
        "1.0"),
    row(CompareFunc::NotEqual, "GL_NOTEQUAL", "Not equal", "Passes if they differ.", "1.0"),
    row(CompareFunc::GreaterEqual, "GL_GEQUAL", "Greater or equal",
        "Passes if the new value is not below the reference.", "1.0"),
    row(CompareFunc::Always, "GL_ALWAYS", "Always", "Everything passes.", "1.0"),
};

/// A row with a long label; `brief` is for narrow controls.
constexpr EnumRow blendFactorRow(BlendFactor value, std::string_view name, std::string_view label,
                                 std::string_view help, std::string_view brief) {
    return {static_cast<std::uint32_t>(value), name, label, help, "1.0", {}, brief};
}

inline constexpr std::array blendFactorRows{
    row(BlendFactor::Zero, "GL_ZERO", "0", "Factor 0.", "1.0"),
    row(BlendFactor::One, "GL_ONE", "1", "Factor 1.", "1.0"),
    row(BlendFactor::SrcColor, "GL_SRC_COLOR", "Source colour", "Times the new fragment's colour.", "1.0"),
    row(BlendFactor::OneMinusSrcColor, "GL_ONE_MINUS_SRC_COLOR", "1 - source colour",
        "Times one minus the new fragment's colour.", "1.0"),
    row(BlendFactor::SrcAlpha, "GL_SRC_ALPHA", "Source alpha", "Times the new fragment's alpha.", "1.0"),
    row(BlendFactor::OneMinusSrcAlpha, "GL_ONE_MINUS_SRC_ALPHA", "1 - source alpha",
        "Times one minus the new fragment's alpha.", "1.0"),
    blendFactorRow(BlendFactor::DstAlpha, "GL_DST_ALPHA", N_("Destination alpha"),
                   N_("Times the stored alpha."), N_("Stored alpha")),
    blendFactorRow(BlendFactor::OneMinusDstAlpha, "GL_ONE_MINUS_DST_ALPHA", N_("1 - destination alpha"),
                   N_("Times one minus the stored alpha."), N_("1 - stored alpha")),
    blendFactorRow(BlendFactor::DstColor, "GL_DST_COLOR", N_("Destination colour"),
                   N_("Times the stored colour."), N_("Stored colour")),
    blendFactorRow(BlendFactor::OneMinusDstColor, "GL_ONE_MINUS_DST_COLOR", N_("1 - destination colour"),
                   N_("Times one minus the stored colour."), N_("1 - stored colour")),
};

template<>
struct EnumTable<ShadeModel> {
    static constexpr std::span<const EnumRow> rows = shadeModelRows;
};
template<>
struct EnumTable<ColorControl> {
    static constexpr std::span<const EnumRow> rows = colorControlRows;
};
template<>
struct EnumTable<CompareFunc> {
    static constexpr std::span<const EnumRow> rows = compareFuncRows;
};
template<>
struct EnumTable<BlendFactor> {
    static constexpr std::span<const EnumRow> rows = blendFactorRows;
};

static_assert(shadeModelRows.size() == 2 && colorControlRows.size() == 2);
static_assert(compareFuncRows.size() == 8 && blendFactorRows.size() == 10);

} // namespace texplorer
