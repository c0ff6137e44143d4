#pragma once

// The enumerants and state of GL_COMBINE: OpenGL 2.1, section 3.8.13, tables 3.23 to 3.25 and 6.20.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class CombineRgb : std::uint32_t {
    Replace = 0x1E01,
    Modulate = 0x2100,
    Add = 0x0104,
    AddSigned = 0x8574,
    Interpolate = 0x8575,
    Subtract = 0x84E7,
    Dot3Rgb = 0x86AE,
    Dot3Rgba = 0x86AF,
};

/// The functions of CombineRgb that exist for alpha; the numbers are the same.
enum class CombineAlpha : std::uint32_t {
    Replace = 0x1E01,
    Modulate = 0x2100,
    Add = 0x0104,
    AddSigned = 0x8574,
    Interpolate = 0x8575,
    Subtract = 0x84E7,
};

enum class CombineSource : std::uint32_t {
    Texture = 0x1702,
    Constant = 0x8576,
    PrimaryColor = 0x8577,
    Previous = 0x8578,
    Texture0 = 0x84C0,
    Texture1 = 0x84C1,
    Texture2 = 0x84C2,
    Texture3 = 0x84C3,
};

enum class OperandRgb : std::uint32_t {
    SrcColor = 0x0300,
    OneMinusSrcColor = 0x0301,
    SrcAlpha = 0x0302,
    OneMinusSrcAlpha = 0x0303,
};

enum class OperandAlpha : std::uint32_t { SrcAlpha = 0x0302, OneMinusSrcAlpha = 0x0303 };

/// GL_RGB_SCALE and GL_ALPHA_SCALE: the only values that are accepted.
enum class CombineScale : std::uint32_t { One = 1, Two = 2, Four = 4 };

/// What a unit in GL_COMBINE computes for colour and for alpha, with GL's initial values.
struct Combine {
    CombineRgb rgb = CombineRgb::Modulate;
    CombineSource source0Rgb = CombineSource::Texture;
    OperandRgb operand0Rgb = OperandRgb::SrcColor;
    CombineSource source1Rgb = CombineSource::Previous;
    OperandRgb operand1Rgb = OperandRgb::SrcColor;
    CombineSource source2Rgb = CombineSource::Constant;
    OperandRgb operand2Rgb = OperandRgb::SrcAlpha;
    CombineScale rgbScale = CombineScale::One;
    CombineAlpha alpha = CombineAlpha::Modulate;
    CombineSource source0Alpha = CombineSource::Texture;
    OperandAlpha operand0Alpha = OperandAlpha::SrcAlpha;
    CombineSource source1Alpha = CombineSource::Previous;
    OperandAlpha operand1Alpha = OperandAlpha::SrcAlpha;
    CombineSource source2Alpha = CombineSource::Constant;
    OperandAlpha operand2Alpha = OperandAlpha::SrcAlpha;
    CombineScale alphaScale = CombineScale::One;

    bool operator==(const Combine&) const = default;
};

inline constexpr std::array combineRgbRows{
    row(CombineRgb::Replace, "GL_REPLACE", "Replace", "Arg0 alone.", "1.3"),
    row(CombineRgb::Modulate, "GL_MODULATE", "Modulate", "Arg0 * Arg1. GL's initial value.", "1.3"),
    row(CombineRgb::Add, "GL_ADD", "Add", "Arg0 + Arg1, clamped to 1.", "1.3"),
    row(CombineRgb::AddSigned, "GL_ADD_SIGNED", "Add signed",
        "Arg0 + Arg1 - 0.5. Grey changes nothing; bump mapping adds a height map and its inverse this way.",
        "1.3"),
    row(CombineRgb::Interpolate, "GL_INTERPOLATE", "Interpolate",
        "Arg0 * Arg2 + Arg1 * (1 - Arg2): the third argument mixes the other two.", "1.3"),
    row(CombineRgb::Subtract, "GL_SUBTRACT", "Subtract", "Arg0 - Arg1, clamped to 0.", "1.3"),
    row(CombineRgb::Dot3Rgb, "GL_DOT3_RGB", "Dot product",
        "Both colours are vectors, with 0 to 1 for -1 to 1. Red, green and blue become 4 times the sum of "
        "(Arg0 - 0.5) * (Arg1 - 0.5). Used for light with normal maps.",
        "1.3"),
    row(CombineRgb::Dot3Rgba, "GL_DOT3_RGBA", "Dot product, alpha too",
        "As GL_DOT3_RGB, and alpha gets the same number. The alpha function is ignored.", "1.3"),
};

inline constexpr std::array combineAlphaRows{
    row(CombineAlpha::Replace, "GL_REPLACE", "Replace", "Arg0 alone.", "1.3"),
    row(CombineAlpha::Modulate, "GL_MODULATE", "Modulate", "Arg0 * Arg1. GL's initial value.", "1.3"),
    row(CombineAlpha::Add, "GL_ADD", "Add", "Arg0 + Arg1, clamped to 1.", "1.3"),
    row(CombineAlpha::AddSigned, "GL_ADD_SIGNED", "Add signed", "Arg0 + Arg1 - 0.5.", "1.3"),
    row(CombineAlpha::Interpolate, "GL_INTERPOLATE", "Interpolate", "Arg0 * Arg2 + Arg1 * (1 - Arg2).",
        "1.3"),
    row(CombineAlpha::Subtract, "GL_SUBTRACT", "Subtract", "Arg0 - Arg1, clamped to 0.", "1.3"),
};

inline constexpr std::array combineSourceRows{
    row(CombineSource::Texture, "GL_TEXTURE", "This texture", "The filtered colour of this unit's texture.",
        "1.3"),
    row(CombineSource::Constant, "GL_CONSTANT", "Environment colour", "This unit's GL_TEXTURE_ENV_COLOR.",
        "1.3"),
    row(CombineSource::PrimaryColor, "GL_PRIMARY_COLOR", "Primary colour",
        "The fragment's colour before texturing, from lighting or glColor.", "1.3"),
    row(CombineSource::Previous, "GL_PREVIOUS", "Previous unit",
        "The result of the unit before this one; in unit 0 the primary colour.", "1.3"),
    row(CombineSource::Texture0, "GL_TEXTURE0", "Texture of unit 0",
        "The filtered colour of unit 0, in any unit (crossbar).", "1.4"),
    row(CombineSource::Texture1, "GL_TEXTURE1", "Texture of unit 1",
        "The filtered colour of unit 1, in any unit (crossbar).", "1.4"),
    row(CombineSource::Texture2, "GL_TEXTURE2", "Texture of unit 2",
        "The filtered colour of unit 2, in any unit (crossbar).", "1.4"),
    row(CombineSource::Texture3, "GL_TEXTURE3", "Texture of unit 3",
        "The filtered colour of unit 3, in any unit (crossbar).", "1.4"),
};

inline constexpr std::array operandRgbRows{
    row(OperandRgb::SrcColor, "GL_SRC_COLOR", "Colour", "The source's red, green and blue.", "1.3"),
    row(OperandRgb::OneMinusSrcColor, "GL_ONE_MINUS_SRC_COLOR", "1 - colour",
        "One minus the source's red, green and blue (inverted).", "1.3"),
    row(OperandRgb::SrcAlpha, "GL_SRC_ALPHA", "Alpha", "The source's alpha in all three components.", "1.3"),
    row(OperandRgb::OneMinusSrcAlpha, "GL_ONE_MINUS_SRC_ALPHA", "1 - alpha",
        "One minus the source's alpha in all three components.", "1.3"),
};

inline constexpr std::array operandAlphaRows{
    row(OperandAlpha::SrcAlpha, "GL_SRC_ALPHA", "Alpha", "The source's alpha.", "1.3"),
    row(OperandAlpha::OneMinusSrcAlpha, "GL_ONE_MINUS_SRC_ALPHA", "1 - alpha",
        "One minus the source's alpha.", "1.3"),
};

inline constexpr std::array combineScaleRows{
    row(CombineScale::One, "1", "1", "The result as it is."),
    row(CombineScale::Two, "2", "2", "Twice the result, clamped to 1 afterwards."),
    row(CombineScale::Four, "4", "4", "Four times the result, clamped to 1 afterwards."),
};

/// How many arguments a function takes: 1 to 3.
[[nodiscard]] constexpr int argumentCount(CombineRgb function) {
    switch (function) {
    case CombineRgb::Replace:
        return 1;
    case CombineRgb::Interpolate:
        return 3;
    default:
        return 2;
    }
}
[[nodiscard]] constexpr int argumentCount(CombineAlpha function) {
    return argumentCount(static_cast<CombineRgb>(function));
}

template<>
struct EnumTable<CombineRgb> {
    static constexpr std::span<const EnumRow> rows = combineRgbRows;
};
template<>
struct EnumTable<CombineAlpha> {
    static constexpr std::span<const EnumRow> rows = combineAlphaRows;
};
template<>
struct EnumTable<CombineSource> {
    static constexpr std::span<const EnumRow> rows = combineSourceRows;
};
template<>
struct EnumTable<OperandRgb> {
    static constexpr std::span<const EnumRow> rows = operandRgbRows;
};
template<>
struct EnumTable<OperandAlpha> {
    static constexpr std::span<const EnumRow> rows = operandAlphaRows;
};
template<>
struct EnumTable<CombineScale> {
    static constexpr std::span<const EnumRow> rows = combineScaleRows;
};

static_assert(combineRgbRows.size() == 8 && combineAlphaRows.size() == 6 && combineSourceRows.size() == 8);
static_assert(operandRgbRows.size() == 4 && operandAlphaRows.size() == 2 && combineScaleRows.size() == 3);

} // namespace texplorer
