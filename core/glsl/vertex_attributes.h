#pragma once

namespace texplorer::glsl {

// The locations of a shader's attributes, as shaders/vertex.glsl declares them.
inline constexpr unsigned positionAttribute = 0;
inline constexpr unsigned normalAttribute = 2;
inline constexpr unsigned colorAttribute = 3;
inline constexpr unsigned firstCoordAttribute = 8; ///< of unit 0; the other units follow

} // namespace texplorer::glsl
