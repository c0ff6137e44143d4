#pragma once

// Functions of C that a program has where it calls them, the same for all scenes.

#include "core/emit/code.h"

#include <cstdint>
#include <set>
#include <vector>

namespace texplorer::emit {

/// In the order in which they stand: each calls only those before it.
enum class CFunction : std::uint8_t {
    Checkerboard,
    Gradient,
    Fill,
    Unpack,
    Halve,
    ReadBmp,
    ReadTga,
    ReadDds,
    MeshTypes, ///< no function: what a mesh is made of
    Turned,    ///< a surface that is turned about an axis, and its quadrilaterals
    Ring,
    Sphere,
    Cylinder,
    Torus,
    Disk,
    Perspective,
    LightInModel,
    Emboss,
    Matrices, ///< of programs whose OpenGL has none: see matrix_functions.h
    Degree,
    Identity,
    Translation,
    Rotation,
    Scaling,
    About,
    Frustum,
    Orthographic,
    FloatProduct,
    SetMatrix,
    SetNormalMatrix,
    NewProgram,
    Buffers,
};

/// A function, with those that it calls.
void addWithCallees(std::set<CFunction>& functions, CFunction function);

[[nodiscard]] std::vector<Line> linesOf(const std::set<CFunction>& functions);

} // namespace texplorer::emit
