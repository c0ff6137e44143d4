#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace texplorer {

// What no parameter's row can know alone: how members of a scene must fit each other. `where` is left empty.

/// A list of coordinates is empty or has one entry for each vertex of the model's mesh.
[[nodiscard]] Result<void> checkTexCoordCount(const Model& model, const TexCoords& list);

/// A unit that is enabled asks for a texture that exists.
[[nodiscard]] Result<void> checkUnitTexture(const Scene& scene, const Unit& unit);

} // namespace texplorer
