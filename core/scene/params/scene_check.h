#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/params/params.h"

namespace texplorer {

// Checks that involve several parameters, which rows cannot check.

/// All of them. `where` is a JSON pointer: "/models/0/mesh/indices/3".
[[nodiscard]] Result<void> checkTogether(const Scene& scene);

// The single checks: `where` is empty, or "/3" for an element of a list.

/// A list of a mesh of the scene's own is empty or has an entry for each position; its indices exist.
[[nodiscard]] Result<void> checkMeshList(const MeshData& mesh, const ParamRow& row);

/// The models of a pass exist, and each occurs once.
[[nodiscard]] Result<void> checkPassModels(const Scene& scene, const Pass& pass);

/// A list of a model: coordinates are none or one for each vertex of its mesh; numbers of vertices exist, and
/// each occurs once.
[[nodiscard]] Result<void> checkVertexList(const Model& model, const ParamRow& row);

/// The texture of an enabled unit exists.
[[nodiscard]] Result<void> checkUnitTexture(const Scene& scene, const Unit& unit);

} // namespace texplorer
