#pragma once

// Functions of C that a program has where it calls them, the same for all scenes: the files of
// assets/programs.

#include "texplorer/emit/code.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// In the order in which they stand: each calls only those before it.
enum class CFunction : std::uint8_t {
    MeshTypes, ///< no function: what a mesh is made of
    Pi,
    Checkerboard,
    Gradient,
    Fill,
    Unpack,
    Halve,
    ReadBmp,
    ReadTga,
    ReadDds,
    Grid, ///< of vertices, and its quadrilaterals: what is turned about an axis
    Ring,
    Sphere,
    Cylinder,
    Torus,
    Disk,
    Perspective,
    LightInModel,
    Emboss,
    Matrices, ///< the type, and multiply(): of programs whose OpenGL has none
    Degree,
    Identity,
    Translation,
    Rotation,
    Scaling,
    Frustum,
    Orthographic,
    FloatProduct,
    SetMatrix,
    SetNormalMatrix,
    NewProgram,
    Buffers,
};

/// A function, with those that it calls: a piece begins with #include of each file that it needs.
void addWithCallees(std::set<CFunction>& functions, CFunction function);

/// Without what they include.
[[nodiscard]] std::vector<Line> linesOf(const std::set<CFunction>& functions);

/// Those of C's library that they include, as "math.h".
[[nodiscard]] std::set<std::string_view> headersOf(const std::set<CFunction>& functions);

/// The lines by which every program has GLFW and OpenGL.
[[nodiscard]] std::string_view openGlHeaders();

} // namespace texplorer::emit
