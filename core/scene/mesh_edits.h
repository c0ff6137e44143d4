#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace texplorer {

// What one does with the vertices of a model of Shape::Mesh, as a value. Lists of normals, colours and
// coordinates that don't have an entry for each vertex have no effect; whoever adds or removes a vertex drops
// them, for they must not fit by chance.

/// Turns a shape into a mesh of the same vertices, in the same order, which draws the same picture: GL_QUADS
/// where each four of them are a quadrilateral, else GL_TRIANGLES with indices. The lists of coordinates
/// stay. Refused, and nothing changes, where it has more than maxMeshVertices or maxMeshIndices, or is one
/// already.
[[nodiscard]] Result<void> turnIntoMesh(Model& model);

/// (0, 0, 1) where the mesh has none.
[[nodiscard]] glm::vec3 givenNormal(const MeshData& mesh, std::size_t vertex);

// `vertex` is one that there is.

/// `together`: those at the same place move along, as the corners of a cube's faces do.
void setPosition(MeshData& mesh, std::size_t vertex, glm::vec3 value, bool together);
/// Where the mesh has no normals, the others get (0, 0, 1).
void setNormal(MeshData& mesh, std::size_t vertex, glm::vec3 value);
/// Where the mesh has no colours, the others get `others`.
void setColor(MeshData& mesh, std::size_t vertex, glm::vec4 value, glm::vec4 others);

/// Adds a vertex like another one, or at the origin where there is none: the last one, which is also drawn
/// last. False where there is no room.
bool appendVertex(Model& model, std::size_t like);

/// Adds one like `vertex` behind it, in the order of drawing too: between those two of a strip or polygon.
/// All later ones move on by one. False where there is no room.
bool duplicateVertex(Model& model, std::size_t vertex);

/// Removes a vertex. With indices, the lines, triangles and quadrilaterals that share no vertices with their
/// neighbours go with it where they name it; what else names it does so no more. An order that is left empty
/// is none: the vertices that remain are drawn one after the other.
void removeVertex(Model& model, std::size_t vertex);

} // namespace texplorer
