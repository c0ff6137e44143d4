#pragma once

// Tables 3.21 and 3.22 of OpenGL 2.1 for users: the cells in symbols, in numbers and as pictures, computed by
// the functions of the renderer.

#include "texplorer/gl/environment.h"
#include "texplorer/image/image.h"
#include "texplorer/reference/shading/environment.h"

#include <glm/vec4.hpp>

#include <array>
#include <string>
#include <string_view>

namespace texplorer::reference {

/// Columns and rows, in the specification's order of formats. GL_COMBINE is not in them.
inline constexpr std::array tableModes{EnvMode::Replace, EnvMode::Modulate, EnvMode::Decal, EnvMode::Blend,
                                       EnvMode::Add};
inline constexpr std::array tableFormats{
    BaseFormat::Alpha,     BaseFormat::Luminance, BaseFormat::LuminanceAlpha,
    BaseFormat::Intensity, BaseFormat::Rgb,       BaseFormat::Rgba};

/// The input colours of the table: RGBA, 0 to 1.
struct TableColors {
    glm::vec4 fragment{1}; ///< Cp, Ap: the colour of the previous unit, or the primary colour
    glm::vec4 texel{1};    ///< of the image, before conversion to the format
    glm::vec4 constant{0}; ///< Cc, Ac

    bool operator==(const TableColors&) const = default;
};

/// With Cs and As for the format.
[[nodiscard]] EnvironmentInputs inputsOf(BaseFormat format, const TableColors& colors);

/// Cs and As for a texel, by table 3.20, with the letters of table 3.15: "Lt", "1".
struct SourceSymbols {
    std::string_view color;
    std::string_view alpha;
};
[[nodiscard]] SourceSymbols sourceSymbols(BaseFormat format);

/// The right side of an equation as printed in textbooks: for "Cv = Cp * (1 - Cs) + Cc * Cs" it is "Cp (1 −
/// Cs) + Cc Cs".
[[nodiscard]] std::string printedEquation(std::string_view symbols);

/// The result of each cell for each texel of `texels` (Rgba8): all pictures in one Rgba8 image, tableModes
/// from left to right, tableFormats from top to bottom, so that the last is in the image's first rows.
/// Undefined cells are transparent.
[[nodiscard]] Image environmentPictures(const Image& texels, const TableColors& colors);

/// A square image of that extent: every hue from left to right, alpha from 0 to 1 from bottom to top.
[[nodiscard]] Image hueAndAlpha(int extent);

} // namespace texplorer::reference
