#pragma once

#include "texplorer/base/shared_list.h"
#include "texplorer/gl/primitive.h"
#include "texplorer/mesh/mesh.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace texplorer {

/// Vertices in a scene, like those of a program between glBegin and glEnd: its own, or those of a file. Each
/// list is empty or has an entry for each position.
struct MeshData {
    Primitive primitive = Primitive::Triangles;
    /// An OBJ file, relative to the scene file; not empty: the lists are those of a part of it, once it is
    /// loaded, and not part of the scene's text (texplorer/mesh/mesh_file.h).
    std::string file{};
    int part = 0; ///< of the file
    SharedList<glm::vec3> positions{};
    SharedList<glm::vec3> normals{}; ///< of any length above 0; empty: +z, the initial normal of OpenGL
    SharedList<glm::vec4> colors{};  ///< replace glColor; empty: glColor
    SharedList<glm::vec4>
        texCoords{}; ///< s, t, r, q for every unit; empty: (0, 0, 0, 1), the initial coordinates of OpenGL
    SharedList<int> indices{}; ///< the vertices in drawing order; empty: as given

    bool operator==(const MeshData&) const = default;
};

/// The limits of a scene's own vertices.
inline constexpr std::size_t maxMeshVertices = 65536;
inline constexpr std::size_t maxMeshIndices = 4 * maxMeshVertices;
/// Those of a part of a file. Surfaces of triangles have about six indices for each vertex.
inline constexpr std::size_t maxFileVertices = 1'000'000;
inline constexpr std::size_t maxFileIndices = 6 * maxFileVertices;

/// The vertices as they are sent, one after the other; invalid indices are left out.
[[nodiscard]] std::vector<std::uint32_t> drawnOrder(const MeshData& data);

/// Makes triangles, lines or points in the order in which OpenGL draws the primitive's parts; vertices that
/// complete no part are ignored (section 2.6.1). The last vertex of a part defines its colour under GL_FLAT,
/// as in table 2.12. Invalid indices are left out, as are lists of a wrong length.
[[nodiscard]] Mesh makeMesh(const MeshData& data);

} // namespace texplorer
