#pragma once

#include "core/scene/scene.h"

namespace texplorer {

/// The coordinates that a unit uses on a model: the scene's where they exist and have one entry a vertex,
/// else the mesh's. `unit` is below maxUnits.
[[nodiscard]] TexCoords effectiveTexCoords(const Model& model, const Mesh& mesh, int unit);

/// The same of one vertex of the mesh, without a list.
[[nodiscard]] glm::vec4 effectiveTexCoord(const Model& model, const Mesh& mesh, int unit, std::size_t vertex);

/// Changes one vertex: fills the unit's list from the mesh first if the scene has none. A vertex that the
/// mesh does not have changes nothing.
void setTexCoord(Model& model, const Mesh& mesh, int unit, std::size_t vertex, glm::vec4 value);

} // namespace texplorer
