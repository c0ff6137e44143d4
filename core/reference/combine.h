#pragma once

// GL_COMBINE: OpenGL 2.1, section 3.8.13, tables 3.23 to 3.25, with crossbar: an argument may be the texture
// colour of any unit.

#include "core/gl/enum_row.h"
#include "core/reference/environment.h"

#include <array>
#include <span>

namespace texplorer::reference {

enum class CombineFunction : std::uint32_t {
    Replace = 0x1E01,
    Modulate = 0x2100,
    Add = 0x0104,
    AddSigned = 0x8574,
    Interpolate = 0x8575,
    Subtract = 0x84E7,
    Dot3Rgb = 0x86AE,  ///< for the colour only
    Dot3Rgba = 0x86AF, ///< for the colour only; it gives alpha, too
};

enum class CombineSource : std::uint32_t {
    Texture = 0x1702, ///< of this unit
    Texture0 = 0x84C0,
    Texture1 = 0x84C1,
    Texture2 = 0x84C2,
    Texture3 = 0x84C3,
    Constant = 0x8576,
    PrimaryColor = 0x8577,
    Previous = 0x8578,
};

enum class CombineOperand : std::uint32_t {
    SrcColor = 0x0300, ///< for the colour only, as the next one
    OneMinusSrcColor = 0x0301,
    SrcAlpha = 0x0302,
    OneMinusSrcAlpha = 0x0303,
};

struct CombineArgument {
    CombineSource source = CombineSource::Texture;
    CombineOperand operand = CombineOperand::SrcColor;
    bool operator==(const CombineArgument&) const = default;
};

/// The state of table 6.20 with GL's initial values.
struct Combine {
    CombineFunction rgb = CombineFunction::Modulate;
    CombineFunction alpha = CombineFunction::Modulate;
    std::array<CombineArgument, 3> rgbArguments{
        CombineArgument{CombineSource::Texture, CombineOperand::SrcColor},
        CombineArgument{CombineSource::Previous, CombineOperand::SrcColor},
        CombineArgument{CombineSource::Constant, CombineOperand::SrcAlpha}};
    std::array<CombineArgument, 3> alphaArguments{
        CombineArgument{CombineSource::Texture, CombineOperand::SrcAlpha},
        CombineArgument{CombineSource::Previous, CombineOperand::SrcAlpha},
        CombineArgument{CombineSource::Constant, CombineOperand::SrcAlpha}};
    float rgbScale = 1; ///< 1, 2 or 4
    float alphaScale = 1;

    bool operator==(const Combine&) const = default;
};

inline constexpr std::array combineFunctionRows{
    row(CombineFunction::Replace, "GL_REPLACE", "Replace", "The first argument alone.", "1.3"),
    row(CombineFunction::Modulate, "GL_MODULATE", "Modulate", "The product of two.", "1.3"),
    row(CombineFunction::Add, "GL_ADD", "Add", "The sum of two.", "1.3"),
    row(CombineFunction::AddSigned, "GL_ADD_SIGNED", "Add signed", "The sum of two, less one half.", "1.3"),
    row(CombineFunction::Interpolate, "GL_INTERPOLATE", "Interpolate",
        "The third mixes between the second (0) and the first (1).", "1.3"),
    row(CombineFunction::Subtract, "GL_SUBTRACT", "Subtract", "The first less the second.", "1.3"),
    row(CombineFunction::Dot3Rgb, "GL_DOT3_RGB", "Dot product",
        "Both colours as vectors from -1 to 1; their dot product in red, green and blue.", "1.3"),
    row(CombineFunction::Dot3Rgba, "GL_DOT3_RGBA", "Dot product, alpha too",
        "The dot product in all four components.", "1.3"),
};
inline constexpr std::array combineSourceRows{
    row(CombineSource::Texture, "GL_TEXTURE", "Texture", "This unit's filtered colour.", "1.3"),
    row(CombineSource::Texture0, "GL_TEXTURE0", "Texture of unit 0", "That unit's filtered colour.", "1.4"),
    row(CombineSource::Texture1, "GL_TEXTURE1", "Texture of unit 1", "That unit's filtered colour.", "1.4"),
    row(CombineSource::Texture2, "GL_TEXTURE2", "Texture of unit 2", "That unit's filtered colour.", "1.4"),
    row(CombineSource::Texture3, "GL_TEXTURE3", "Texture of unit 3", "That unit's filtered colour.", "1.4"),
    row(CombineSource::Constant, "GL_CONSTANT", "Constant", "The unit's environment colour.", "1.3"),
    row(CombineSource::PrimaryColor, "GL_PRIMARY_COLOR", "Primary colour",
        "The fragment's colour before any texture.", "1.3"),
    row(CombineSource::Previous, "GL_PREVIOUS", "Previous",
        "What the unit before gave; for unit 0 the primary colour.", "1.3"),
};
inline constexpr std::array combineOperandRows{
    row(CombineOperand::SrcColor, "GL_SRC_COLOR", "Colour", "The source's colour.", "1.3"),
    row(CombineOperand::OneMinusSrcColor, "GL_ONE_MINUS_SRC_COLOR", "1 - colour", "Its complement.", "1.3"),
    row(CombineOperand::SrcAlpha, "GL_SRC_ALPHA", "Alpha", "The source's alpha.", "1.3"),
    row(CombineOperand::OneMinusSrcAlpha, "GL_ONE_MINUS_SRC_ALPHA", "1 - alpha", "Its complement.", "1.3"),
};

/// `textures` are the texture source colours of all units, for the crossbar; one that is not there (its unit
/// is off) makes the result undefined: the incoming colour is passed on. So does a DOT3 function for alpha,
/// or a colour operand there: GL refuses both.
[[nodiscard]] EnvironmentResult evaluate(const Combine& combine, const EnvironmentInputs& inputs,
                                         std::span<const glm::vec4* const> textures = {});

} // namespace texplorer::reference

namespace texplorer {

template<>
struct EnumTable<reference::CombineFunction> {
    static constexpr std::span<const EnumRow> rows = reference::combineFunctionRows;
};
template<>
struct EnumTable<reference::CombineSource> {
    static constexpr std::span<const EnumRow> rows = reference::combineSourceRows;
};
template<>
struct EnumTable<reference::CombineOperand> {
    static constexpr std::span<const EnumRow> rows = reference::combineOperandRows;
};

static_assert(reference::combineFunctionRows.size() == 8 && reference::combineSourceRows.size() == 8 &&
              reference::combineOperandRows.size() == 4);

} // namespace texplorer
