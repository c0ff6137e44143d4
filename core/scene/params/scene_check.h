#pragma once

#include "core/base/result.h"
#include "core/scene/params/params.h"

namespace texplorer {

// What no parameter's row can know alone: how members of a scene must fit each other.

/// All of it. `where` is a JSON pointer: "/models/0/mesh/indices/3".
[[nodiscard]] Result<void> checkTogether(const Scene& scene);

// One by one: `where` is left empty, or "/3" for an element of a list.

/// A list of a model's own vertices has as many elements as there are positions, or none; its indices name
/// positions that exist.
[[nodiscard]] Result<void> checkMeshList(const MeshData& mesh, const ParamRow& row);

/// A pass names models that exist, each once.
[[nodiscard]] Result<void> checkPassModels(const Scene& scene, const Pass& pass);

/// A list of coordinates is empty or has one entry for each vertex of the model's mesh.
[[nodiscard]] Result<void> checkTexCoordCount(const Model& model, const TexCoords& list);

/// A unit that is enabled asks for a texture that exists.
[[nodiscard]] Result<void> checkUnitTexture(const Scene& scene, const Unit& unit);

} // namespace texplorer
