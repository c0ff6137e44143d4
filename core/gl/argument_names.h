#pragma once

// What calls take that is no parameter's value: it has a name, but neither a label nor a help. The numbers
// are OpenGL's affair, as only C that is written out has these names.

#include "core/gl/combine.h"

#include <cstddef>
#include <string_view>

namespace texplorer {

[[nodiscard]] constexpr std::string_view booleanName(bool value) {
    return value ? "GL_TRUE" : "GL_FALSE";
}

/// GL_TEXTURE0 for unit 0: what a crossbar reads has the same names.
[[nodiscard]] constexpr std::string_view textureUnitName(std::size_t unit) {
    return rowOf(static_cast<CombineSource>(static_cast<std::size_t>(CombineSource::Texture0) + unit)).name;
}

/// Of glMatrixMode: section 2.11.2.
inline constexpr std::string_view modelViewMode = "GL_MODELVIEW";
inline constexpr std::string_view projectionMode = "GL_PROJECTION";
inline constexpr std::string_view textureMode = rowOf(CombineSource::Texture).name; // one enumerant for both

/// What numbers in memory are: tables 2.4, 3.5 and 3.6.
inline constexpr std::string_view unsignedByteType = "GL_UNSIGNED_BYTE";
inline constexpr std::string_view unsignedIntType = "GL_UNSIGNED_INT";
inline constexpr std::string_view floatType = "GL_FLOAT";
inline constexpr std::string_view depthPixels = "GL_DEPTH_COMPONENT";

/// Of glBindBuffer: section 2.9.
inline constexpr std::string_view arrayBuffer = "GL_ARRAY_BUFFER";
inline constexpr std::string_view elementArrayBuffer = "GL_ELEMENT_ARRAY_BUFFER";

/// Of glEnableClientState: section 2.8.
inline constexpr std::string_view vertexArray = "GL_VERTEX_ARRAY";
inline constexpr std::string_view normalArray = "GL_NORMAL_ARRAY";
inline constexpr std::string_view colorArray = "GL_COLOR_ARRAY";
inline constexpr std::string_view texCoordArray = "GL_TEXTURE_COORD_ARRAY";

} // namespace texplorer
