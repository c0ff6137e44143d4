#pragma once

// One function per shape, each in its own file. makeMesh is the only caller.

#include "core/mesh/mesh.h"

#include <array>

namespace texplorer {

[[nodiscard]] Mesh makeCube();
[[nodiscard]] Mesh makeSphere(int slices, int stacks); ///< within the limits of mesh.h
[[nodiscard]] Mesh makeQuad();
[[nodiscard]] Mesh makeFloor();
[[nodiscard]] Mesh makeCylinder(float topRadius, int slices, int stacks);
[[nodiscard]] Mesh makeDisk(float innerRadius, int slices, int rings);
[[nodiscard]] Mesh makePartialDisk(const ShapeOptions& options); ///< likewise
[[nodiscard]] Mesh makeTorus(float tubeRadius, int slices, int stacks);

/// Adds the two triangles of a quadrilateral, whose corners run counter-clockwise: see Mesh.
void addQuad(Mesh& mesh, const std::array<std::uint32_t, 4>& corners);

/// Four corners of a plane rectangle. `right` and `up` lead from the lower left corner along s and t, so that
/// the image stands upright for a viewer who looks against `normal`.
struct Patch {
    glm::vec3 lowerLeft;
    glm::vec3 right;
    glm::vec3 up;
    glm::vec4 texLowerLeft{0, 0, 0, 1};
    glm::vec4 texUpperRight{1, 1, 0, 1};
};

/// Adds four vertices, two triangles and the face that they make, beginning at the lower left corner.
void addPatch(Mesh& mesh, std::string name, const Patch& patch);

} // namespace texplorer
