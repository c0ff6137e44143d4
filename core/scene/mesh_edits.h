#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

namespace texplorer {

// Edits of the vertices of a model of Shape::Mesh. Lists of normals, colours and coordinates that do not have
// an entry for each vertex have no effect; functions that add or remove a vertex remove them, so that they do
// not fit by accident. The numbers of vertices without glTexCoord (Model::noTexCoord) follow their vertices.

/// Converts a shape to a mesh with the same vertices in the same order, which draws the same picture:
/// GL_QUADS if each four of them are a quadrilateral, else GL_TRIANGLES with indices. The lists of
/// coordinates stay. Errors, without changes: more than maxMeshVertices or maxMeshIndices, or already a mesh.
[[nodiscard]] Result<void> turnIntoMesh(Model& model);

/// Makes the vertices of a file the scene's own, which edits need. Errors, without changes: TooLarge for more
/// than maxMeshVertices or maxMeshIndices.
[[nodiscard]] Result<void> takeVertices(MeshData& mesh);

/// (0, 0, 1) if the mesh has no normals.
[[nodiscard]] glm::vec3 givenNormal(const MeshData& mesh, std::size_t vertex);

// In these functions, `vertex` must exist.

/// `together`: also moves the vertices at the same position, such as the corners of a cube's faces.
void setPosition(MeshData& mesh, std::size_t vertex, glm::vec3 value, bool together);
/// If the mesh has no normals, the others become (0, 0, 1).
void setNormal(MeshData& mesh, std::size_t vertex, glm::vec3 value);
/// If the mesh has no colours, the others become `others`.
void setColor(MeshData& mesh, std::size_t vertex, glm::vec4 value, glm::vec4 others);

/// Appends a copy of a vertex, or one at the origin if the mesh is empty; it is also last in the drawing
/// order. Returns false if there is no room.
bool appendVertex(Model& model, std::size_t like);

/// Inserts a copy of `vertex` after it, in the drawing order too: in a strip or polygon, between the two. The
/// indices of later vertices increase by one. Returns false if there is no room.
bool duplicateVertex(Model& model, std::size_t vertex);

/// Removes a vertex. With indices, separate lines, triangles and quadrilaterals that use it are removed; from
/// other primitives only the index is removed. If no indices are left, the remaining vertices are drawn in
/// order.
void removeVertex(Model& model, std::size_t vertex);

} // namespace texplorer
