#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/gl/enum_row.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <compare>
#include <string>
#include <vector>

namespace texplorer {

enum class Shape : std::uint32_t {
    Cube,
    Sphere,
    Quad,
    Floor,
    Cylinder,
    Disk,
    PartialDisk,
    Torus,
    Teapot,
    Mesh
};

inline constexpr std::array shapeRows{
    row(Shape::Cube, "cube", "Cube",
        "24 vertices, so each of the six faces has its own texture coordinates."),
    row(Shape::Sphere, "sphere", "Sphere",
        "Slices and stacks with gluSphere's texture coordinates: s goes around, t from pole to pole."),
    row(Shape::Quad, "quad", "Square", "A square that faces the viewer."),
    row(Shape::Floor, "floor", "Floor",
        "A long tiled floor into the distance, to show minification and anisotropy."),
    row(Shape::Cylinder, "cylinder", "Cylinder",
        "gluCylinder, upright and without lids. With a top radius of 0 it is a cone."),
    row(Shape::Disk, "disk", "Disk", "gluDisk: the image lies flat on it, with a hole in the middle."),
    row(Shape::PartialDisk, "partialDisk", "Partial disk",
        "gluPartialDisk: a sector of a disk, clockwise from the start angle."),
    row(Shape::Torus, "torus", "Torus", "A ring: s goes around it, t around its tube."),
    row(Shape::Teapot, "teapot", "Teapot",
        "M. Newell's teapot of Bézier patches. The image goes once around the body, lid, handle and spout."),
    row(Shape::Mesh, "mesh", "Mesh", "A list of vertices: triangles, quads, lines or points."),
};

template<>
struct EnumTable<Shape> {
    static constexpr std::span<const EnumRow> rows = shapeRows;
};

static_assert(shapeRows.size() == 10);

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;   ///< unit length, outwards; 0 in a scene's own mesh without normals
    glm::vec4 texCoord; ///< s, t, r, q: the mesh's coordinates, which the scene can replace
    glm::vec4 color{1}; ///< if the mesh has colours

    bool operator==(const Vertex&) const = default;
};

/// A named part of a mesh, for outlines in the texture view and groups in the vertex list.
struct Face {
    Sentence name;                       ///< "Front", "Stack 3"
    std::vector<std::uint32_t> vertices; ///< an outline, counter-clockwise seen from outside
    bool closed = true;                  ///< the outline returns to its first vertex
};

/// Triangles, counter-clockwise seen from outside, or lines or points, in a right-handed space with y up. A
/// value type.
///
/// A quadrilateral with the corners 0, 1, 2, 3 becomes the triangles 0, 1, 3 and 1, 2, 3. OpenGL does not
/// define the division, and the two diagonals give different coordinates and colours between the corners
/// unless these are linear. Mesa divides GL_QUAD_STRIP, and so gluSphere, in this way, and also GL_QUADS in
/// display lists, with indices, under GL_FLAT and where it clips: a program that draws the same corners in
/// one of these ways gets the same pixels. (In other cases, Mesa 22.3 divides GL_QUADS the other way.) Corner
/// 3 comes last: under GL_FLAT both triangles have its colour, as OpenGL requires for quadrilaterals (section
/// 2.14.7).
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> triangles; ///< three indices each
    std::vector<Face> faces;
    std::vector<std::uint32_t> lines{};  ///< two indices each
    std::vector<std::uint32_t> points{}; ///< one index each
    bool colored = false;                ///< the vertices have colours
};

inline constexpr int minSlices = 3;
inline constexpr int minStacks = 2;
inline constexpr int maxSubdivision = 256;
/// The maximum for which all lists of coordinates are short enough.
inline constexpr int maxTeapotStacks = 24;

/// The parameters of a shape. Each is used by the shapes in its comment.
struct ShapeOptions {
    Shape shape = Shape::Cube;
    int slices = 32; ///< around the axis: sphere, cylinder, disks, torus, each part of the teapot; 3 to 256
    /// Sphere, cylinder: along the axis; disks: rings; torus: around its tube, at least 3; teapot: along each
    /// patch, at most 24; 2 to 256.
    int stacks = 16;
    float topRadius = 1;     ///< cylinder
    float innerRadius = 0;   ///< disks: of the hole, 0 to 1
    float tubeRadius = 0.4F; ///< torus
    float startAngle = 0;    ///< partial disk: degrees from +y towards +x
    float sweepAngle = 270;  ///< partial disk: degrees

    auto operator<=>(const ShapeOptions&) const = default; // NOLINT(modernize-use-nullptr): false positive
};

/// Makes the mesh of a shape; empty for Shape::Mesh (see mesh_data.h). Extents: the cube and the quad reach
/// from -1 to 1, the sphere has radius 1, the floor is at y = -1 from x = -4 to 4 and from z = 4 to -76, with
/// s in [0, 8] and t in [0, 80]: one tile per unit. The sphere's s is gluSphere's: 0 to 1 eastwards around
/// the axis, 0.5 at the front (+z); its t is 0 at the south pole (y = -1) and 1 at the north pole. Its
/// vertices are rows of slices + 1 from the south pole up; its faces are the stacks. The order of its
/// triangles is gluSphere's with texture coordinates: from the north pole down, and westwards around the
/// axis, with as many points at each pole as there are slices.
///
/// The cylinder is gluCylinder's, turned like the sphere: from y = -1, with radius 1, to y = 1, with the top
/// radius; its s is the sphere's, its t is 0 at the base and 1 at the top. (GLU's manual describes s in the
/// opposite direction; its library is followed.) The disks are gluDisk's and gluPartialDisk's with radius 1:
/// in the plane z = 0, facing +z, with the picture projected flat; rows go from the rim inwards, and the
/// middle has as many vertices as the rim. A negative sweep goes the other way around; one beyond 360 degrees
/// is a full turn. The torus has a ring of radius 1 around the y axis; its s goes around like the sphere's,
/// its t around the tube: 0 at the hole, 0.25 below, 0.5 outside.
///
/// The teapot is M. Newell's, with the size and position of glutSolidTeapot(1), but counter-clockwise: the
/// body has radius 1, the bottom is at y = -0.75 and the top of the lid at 0.825, the handle points to -x and
/// the spout to +x. Unlike in GLUT, the image does not repeat for each patch: s goes around body and lid as
/// around the sphere, t from the bottom's centre to the rim and from the lid's edge to its top; around handle
/// and spout, s begins on the inner side, towards the lid, and goes via the front (+z), and t runs from the
/// handle's upper end to its lower one and from the body to the spout's tip.
[[nodiscard]] Mesh makeMesh(const ShapeOptions& options);

/// The number of vertices of makeMesh, without making it.
[[nodiscard]] std::size_t vertexCount(const ShapeOptions& options);

} // namespace texplorer
