#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer {

/// Returns the coordinates of a unit for a model: the scene's if they have an entry for each vertex, else the
/// mesh's. `unit` is below maxUnits.
[[nodiscard]] TexCoords effectiveTexCoords(const Model& model, const Mesh& mesh, int unit);

/// The same for one vertex of the mesh, without making a list.
[[nodiscard]] glm::vec4 effectiveTexCoord(const Model& model, const Mesh& mesh, int unit, std::size_t vertex);

/// Sets the coordinates of a vertex; first fills the unit's list from the mesh if it is empty. A vertex that
/// does not exist is ignored.
void setTexCoord(Model& model, const Mesh& mesh, int unit, std::size_t vertex, glm::vec4 value);

} // namespace texplorer
