#pragma once

#include "core/gl/primitive.h"
#include "core/mesh/mesh.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace texplorer {

/// Vertices that a scene gives itself, as a program gives them between glBegin and glEnd. Each list is empty
/// or has an entry for each position.
struct MeshData {
    Primitive primitive = Primitive::Triangles;
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{};   ///< of any length above 0; empty: +z, as glNormal begins with
    std::vector<glm::vec4> colors{};    ///< takes the place of glColor; empty: glColor
    std::vector<glm::vec4> texCoords{}; ///< s, t, r, q for every unit; empty: (0, 0, 0, 1), as glTexCoord
    std::vector<int> indices{}; ///< the vertices in the order in which they are drawn; empty: as given

    bool operator==(const MeshData&) const = default;
};

inline constexpr std::size_t maxMeshVertices = 65536;
inline constexpr std::size_t maxMeshIndices = 4 * maxMeshVertices;

/// The mesh: triangles, lines or points, in the order in which OpenGL draws the primitive's parts; vertices
/// that complete no part are left over (section 2.6.1). The last vertex of a part is the one whose colour it
/// has under GL_FLAT, as table 2.12 says. Indices beyond the positions are left out, as are lists that don't
/// fit.
[[nodiscard]] Mesh makeMesh(const MeshData& data);

} // namespace texplorer
