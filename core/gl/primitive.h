#pragma once

// Primitives: OpenGL 2.1, section 2.6.1.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class Primitive : std::uint32_t {
    Points = 0x0000,
    Lines = 0x0001,
    LineLoop = 0x0002,
    LineStrip = 0x0003,
    Triangles = 0x0004,
    TriangleStrip = 0x0005,
    TriangleFan = 0x0006,
    Quads = 0x0007,
    QuadStrip = 0x0008,
    Polygon = 0x0009,
};

inline constexpr std::array primitiveRows{
    row(Primitive::Points, "GL_POINTS", "Points", "Every vertex is a square of the point size.", "1.0"),
    row(Primitive::Lines, "GL_LINES", "Lines", "Every two vertices are a line.", "1.0"),
    row(Primitive::LineStrip, "GL_LINE_STRIP", "Line strip", "A line from each vertex to the next.", "1.0"),
    row(Primitive::LineLoop, "GL_LINE_LOOP", "Line loop",
        "A line from each vertex to the next, and from the last back to the first.", "1.0"),
    row(Primitive::Triangles, "GL_TRIANGLES", "Triangles", "Every three vertices are a triangle.", "1.0"),
    row(Primitive::TriangleStrip, "GL_TRIANGLE_STRIP", "Triangle strip",
        "Each vertex makes a triangle with the two before it.", "1.0"),
    row(Primitive::TriangleFan, "GL_TRIANGLE_FAN", "Triangle fan",
        "Each vertex makes a triangle with the one before it and the first.", "1.0"),
    row(Primitive::Quads, "GL_QUADS", "Quads", "Every four vertices are a quadrilateral.", "1.0"),
    row(Primitive::QuadStrip, "GL_QUAD_STRIP", "Quad strip",
        "Every two vertices make a quadrilateral with the two before them.", "1.0"),
    row(Primitive::Polygon, "GL_POLYGON", "Polygon", "All vertices are the corners of one convex polygon.",
        "1.0"),
};

template<>
struct EnumTable<Primitive> {
    static constexpr std::span<const EnumRow> rows = primitiveRows;
};

static_assert(primitiveRows.size() == 10);

} // namespace texplorer
