#pragma once

// Tables 3.21 and 3.22 of OpenGL 2.1 for a reader: the cells in symbols, in numbers and as pictures, all of
// them by the functions that the renderer calls.

#include "core/gl/environment.h"
#include "core/image/image.h"
#include "core/reference/shading/environment.h"

#include <glm/vec4.hpp>

#include <array>
#include <string>
#include <string_view>

namespace texplorer::reference {

/// Columns and rows, in the specification's order of formats. GL_COMBINE has tables of its own.
inline constexpr std::array tableModes{EnvMode::Replace, EnvMode::Modulate, EnvMode::Decal, EnvMode::Blend,
                                       EnvMode::Add};
inline constexpr std::array tableFormats{
    BaseFormat::Alpha,     BaseFormat::Luminance, BaseFormat::LuminanceAlpha,
    BaseFormat::Intensity, BaseFormat::Rgb,       BaseFormat::Rgba};

/// What the table is worked out for: RGBA, 0 to 1.
struct TableColors {
    glm::vec4 fragment{1}; ///< Cp, Ap: of the unit before, or the primary colour
    glm::vec4 texel{1};    ///< of the image, before the format takes its part
    glm::vec4 constant{0}; ///< Cc, Ac

    bool operator==(const TableColors&) const = default;
};

/// With Cs and As as a format makes them of the texel.
[[nodiscard]] EnvironmentInputs inputsOf(BaseFormat format, const TableColors& colors);

/// What Cs and As are of a texel, by table 3.20, with the letters of table 3.15: "Lt", "1".
struct SourceSymbols {
    std::string_view color;
    std::string_view alpha;
};
[[nodiscard]] SourceSymbols sourceSymbols(BaseFormat format);

/// The right side of an equation as a textbook prints it: of "Cv = Cp * (1 - Cs) + Cc * Cs" it is
/// "Cp (1 − Cs) + Cc Cs".
[[nodiscard]] std::string printedEquation(std::string_view symbols);

/// What each cell makes of `texels` (Rgba8), each of which is a texel in turn: all of these pictures in one
/// image, Rgba8, tableModes from left to right, tableFormats from top to bottom, which is the last row of an
/// image. Where a cell is undefined, it is transparent.
[[nodiscard]] Image environmentPictures(const Image& texels, const TableColors& colors);

/// So many pixels a side: from left to right every hue, from bottom to top alpha from 0 to 1.
[[nodiscard]] Image hueAndAlpha(int extent);

} // namespace texplorer::reference
