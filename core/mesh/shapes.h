#pragma once

// One function per shape, each in its own file; called only by makeMesh.

#include "texplorer/mesh/mesh.h"

#include <glm/vec2.hpp>

#include <array>
#include <span>

namespace texplorer {

[[nodiscard]] Mesh makeCube();
[[nodiscard]] Mesh makeQuad();
[[nodiscard]] Mesh makeFloor();
// The arguments must be within the limits of mesh.h.
[[nodiscard]] Mesh makeSphere(int slices, int stacks);
[[nodiscard]] Mesh makeCylinder(float topRadius, int slices, int stacks);
[[nodiscard]] Mesh makeDisk(float innerRadius, int slices, int rings);
[[nodiscard]] Mesh makePartialDisk(const ShapeOptions& options);
[[nodiscard]] Mesh makeTorus(float tubeRadius, int slices, int stacks);
[[nodiscard]] Mesh makeTeapot(int slices, int stacks);

struct Circle {
    float sine;
    float cosine;
};

/// A point of the unit circle, at an angle in quarter turns. Whole quarters are exact, so poles are points
/// and seams have no gap.
[[nodiscard]] Circle circleAt(double quarters);

void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c);

/// Adds the two triangles of a quadrilateral with counter-clockwise corners: see Mesh.
void addQuad(Mesh& mesh, const std::array<std::uint32_t, 4>& corners);

// For meshes of rows of slices + 1 vertices, which run eastwards; the next row is on their left.

/// Adds a face for each two adjacent rows from `firstRow` on, "Stack 1" and so on: along the first and back
/// along the second.
void addBandFaces(Mesh& mesh, const char* name, int slices, int firstRow, int stacks);

/// Adds the quadrilaterals between a row and the next, westwards, in the order of the GL_QUAD_STRIPs of GLU's
/// quadrics.
void addBandQuads(Mesh& mesh, int slices, int row);

/// A circle around the y axis.
struct Ring {
    float radius;
    float height;
    glm::vec2 normal; ///< outwards and up
};

/// Returns the vertices of a surface of revolution about the y axis, a row for each ring, from below or
/// inside, and the faces between them; no triangles. s = 0 is at the back (-z) and grows eastwards: 0.25 at
/// the left (-x), 0.5 at the front, 0.75 at the right. t grows evenly from row to row. The seam has two
/// vertices, and a pole one for each s, as one position there needs several texture coordinates.
[[nodiscard]] Mesh turned(std::span<const Ring> rings, int slices);

/// A rectangle, by its corner and edges. `right` and `up` lead from the lower left corner along s and t, so
/// that the image is upright for a viewer who looks against `normal`.
struct Patch {
    glm::vec3 lowerLeft;
    glm::vec3 right;
    glm::vec3 up;
    glm::vec4 texLowerLeft{0, 0, 0, 1};
    glm::vec4 texUpperRight{1, 1, 0, 1};
};

/// Adds four vertices, two triangles and their face, beginning at the lower left corner.
void addPatch(Mesh& mesh, std::string name, const Patch& patch);

} // namespace texplorer
