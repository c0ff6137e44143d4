#pragma once

#include "texplorer/gl/primitive.h"
#include "texplorer/mesh/mesh.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace texplorer {

/// Vertices in a scene, like those of a program between glBegin and glEnd. Each list is empty or has an entry
/// for each position.
struct MeshData {
    Primitive primitive = Primitive::Triangles;
    std::vector<glm::vec3> positions{};
    std::vector<glm::vec3> normals{}; ///< of any length above 0; empty: +z, the initial normal of OpenGL
    std::vector<glm::vec4> colors{};  ///< replace glColor; empty: glColor
    std::vector<glm::vec4>
        texCoords{}; ///< s, t, r, q for every unit; empty: (0, 0, 0, 1), the initial coordinates of OpenGL
    std::vector<int> indices{}; ///< the vertices in drawing order; empty: as given

    bool operator==(const MeshData&) const = default;
};

inline constexpr std::size_t maxMeshVertices = 65536;
inline constexpr std::size_t maxMeshIndices = 4 * maxMeshVertices;

/// The vertices as they are sent, one after the other; invalid indices are left out.
[[nodiscard]] std::vector<std::uint32_t> drawnOrder(const MeshData& data);

/// Makes triangles, lines or points in the order in which OpenGL draws the primitive's parts; vertices that
/// complete no part are ignored (section 2.6.1). The last vertex of a part defines its colour under GL_FLAT,
/// as in table 2.12. Invalid indices are left out, as are lists of a wrong length.
[[nodiscard]] Mesh makeMesh(const MeshData& data);

} // namespace texplorer
