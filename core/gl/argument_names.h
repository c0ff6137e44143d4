#pragma once

// Names of arguments of calls that are not parameter values: they have no label and no help. The numbers are
// not needed, as only generated C code contains these names.

#include "texplorer/gl/combine.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace texplorer {

[[nodiscard]] constexpr std::string_view booleanName(bool value) {
    return value ? "GL_TRUE" : "GL_FALSE";
}

/// GL_TEXTURE0 for unit 0; crossbar sources have the same names.
[[nodiscard]] constexpr std::string_view textureUnitName(std::size_t unit) {
    return rowOf(static_cast<CombineSource>(static_cast<std::size_t>(CombineSource::Texture0) + unit)).name;
}

/// For glMatrixMode: section 2.11.2.
inline constexpr std::string_view modelViewMode = "GL_MODELVIEW";
inline constexpr std::string_view projectionMode = "GL_PROJECTION";
inline constexpr std::string_view textureMode =
    rowOf(CombineSource::Texture).name; // the same enumerant for both

/// Types of numbers in memory: tables 2.4, 3.5 and 3.6.
inline constexpr std::string_view unsignedByteType = "GL_UNSIGNED_BYTE";
inline constexpr std::string_view unsignedIntType = "GL_UNSIGNED_INT";
inline constexpr std::string_view floatType = "GL_FLOAT";
inline constexpr std::string_view depthPixels = "GL_DEPTH_COMPONENT";

/// For glPixelTransferf, of red, green, blue and alpha: table 3.2.
inline constexpr std::array<std::string_view, 4> transferScales{"GL_RED_SCALE", "GL_GREEN_SCALE",
                                                                "GL_BLUE_SCALE", "GL_ALPHA_SCALE"};
inline constexpr std::array<std::string_view, 4> transferBiases{"GL_RED_BIAS", "GL_GREEN_BIAS",
                                                                "GL_BLUE_BIAS", "GL_ALPHA_BIAS"};

/// For glBindBuffer: section 2.9.
inline constexpr std::string_view arrayBuffer = "GL_ARRAY_BUFFER";
inline constexpr std::string_view elementArrayBuffer = "GL_ELEMENT_ARRAY_BUFFER";

/// For glEnableClientState: section 2.8.
inline constexpr std::string_view vertexArray = "GL_VERTEX_ARRAY";
inline constexpr std::string_view normalArray = "GL_NORMAL_ARRAY";
inline constexpr std::string_view colorArray = "GL_COLOR_ARRAY";
inline constexpr std::string_view texCoordArray = "GL_TEXTURE_COORD_ARRAY";

} // namespace texplorer
