#pragma once

#include "core/gl/enum_row.h"

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
        "24 vertices, so that each of the six faces has its own texture coordinates."),
    row(Shape::Sphere, "sphere", "Sphere",
        "Slices and stacks with gluSphere's texture coordinates: s goes around, t from pole to pole."),
    row(Shape::Quad, "quad", "Square", "A square that faces the viewer: one texture, nothing in the way."),
    row(Shape::Floor, "floor", "Floor",
        "A long floor into the distance, tiled: where minification and anisotropy show."),
    row(Shape::Cylinder, "cylinder", "Cylinder",
        "gluCylinder, upright, without lids; with a top radius of 0 it is a cone."),
    row(Shape::Disk, "disk", "Disk", "gluDisk: the image lies flat on it, and a hole cuts its middle out."),
    row(Shape::PartialDisk, "partialDisk", "Partial disk",
        "gluPartialDisk: a sector of a disk, from the start angle on, clockwise."),
    row(Shape::Torus, "torus", "Torus", "A ring: s goes around it, t around its tube."),
    row(Shape::Teapot, "teapot", "Teapot",
        "M. Newell's, of Bézier patches: the image goes once around its body, lid, handle and spout each."),
    row(Shape::Mesh, "mesh", "Mesh", "Vertices of its own: triangles, quads, lines or points."),
};

template<>
struct EnumTable<Shape> {
    static constexpr std::span<const EnumRow> rows = shapeRows;
};

static_assert(shapeRows.size() == 10);

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;   ///< unit length, outwards; 0 where a mesh of its own gives none
    glm::vec4 texCoord; ///< s, t, r, q: what the mesh gives unless the scene says otherwise
    glm::vec4 color{1}; ///< where the mesh has colours

    bool operator==(const Vertex&) const = default;
};

/// A named part of a mesh: what a texture view outlines and a vertex list groups by.
struct Face {
    std::string name;                    ///< "Front", "Stack 3"
    std::vector<std::uint32_t> vertices; ///< an outline, counter-clockwise seen from outside
    bool closed = true;                  ///< whether it leads back to its first vertex
};

/// Triangles, counter-clockwise seen from outside, or lines or points, in a right-handed space with y up. A
/// value without handles.
///
/// A quadrilateral with the corners 0, 1, 2, 3 becomes the triangles 0, 1, 3 and 1, 2, 3. OpenGL leaves the
/// division open, and between the corners the two diagonals give different coordinates and colours wherever
/// these aren't linear. This is how Mesa divides GL_QUAD_STRIP, and with it gluSphere, and GL_QUADS in
/// display lists, with indices, under GL_FLAT and where it clips: a program that draws the same corners that
/// way gives the same pixels. (Without all of these Mesa 22.3 divides GL_QUADS the other way.) Corner 3 comes
/// last: under GL_FLAT both triangles have its colour, as OpenGL asks of a quadrilateral (section 2.14.7).
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> triangles; ///< three indices each
    std::vector<Face> faces;
    std::vector<std::uint32_t> lines{};  ///< two indices each
    std::vector<std::uint32_t> points{}; ///< one index each
    bool colored = false;                ///< whether its vertices have colours of their own
};

inline constexpr int minSlices = 3;
inline constexpr int minStacks = 2;
inline constexpr int maxSubdivision = 256;
inline constexpr int maxTeapotStacks = 24; ///< with which no list of its coordinates becomes too long

/// What a shape is made from. Each number counts for the shapes that it names.
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

    auto operator<=>(const ShapeOptions&) const = default; // NOLINT(modernize-use-nullptr): there is none
};

/// The mesh of a shape; none for Shape::Mesh (see mesh_data.h). Extents: the cube and the quad reach from -1
/// to 1, the sphere has radius 1, the floor lies at y = -1 from x = -4 to 4 and from z = 4 to -76, with s in
/// [0, 8] and t in [0, 80]: one tile a unit.
/// The sphere's s follows gluSphere: 0 to 1 eastwards around the axis, 0.5 at the front (+z), its t 0 at the
/// south pole (y = -1) and 1 at the north pole. Its vertices lie in rows of slices + 1 from the south pole
/// up; its faces are the stacks. Its triangles come as gluSphere draws them with texture coordinates: from
/// the north pole down, and westwards around the axis, with as many points at each pole as there are slices.
///
/// The cylinder is gluCylinder's, turned as the sphere: from y = -1, with radius 1, to y = 1, with the top
/// radius; its s is the sphere's, its t 0 at the base and 1 at the top. (GLU's manual has s grow the other
/// way around; its library doesn't.) The disks are gluDisk's and gluPartialDisk's with radius 1: in the plane
/// z = 0, facing +z, the picture flat on them; rows go from the rim inwards, and the middle has as many
/// vertices as the rim. A negative sweep goes the other way around; one beyond 360 degrees is a whole turn.
/// The torus has a ring of radius 1 around the y axis; its s goes around as the sphere's, its t around the
/// tube: 0 at the hole, 0.25 below, 0.5 outside.
///
/// The teapot is M. Newell's, as big and where glutSolidTeapot(1) draws it, but counter-clockwise: the body
/// has the radius 1, the bottom lies at y = -0.75 and the top of the lid at 0.825, the handle points to -x
/// and the spout to +x. Unlike GLUT's, its patches don't have the whole image each: s goes around body and
/// lid as around the sphere, t from the bottom's middle to the rim and from the lid's edge to its top; around
/// handle and spout s begins on the inner side, towards the lid, and goes by the front (+z), and t runs from
/// the handle's upper end to its lower one and from the body to the spout's tip.
[[nodiscard]] Mesh makeMesh(const ShapeOptions& options);

/// How many vertices makeMesh gives, without making it.
[[nodiscard]] std::size_t vertexCount(const ShapeOptions& options);

} // namespace texplorer
