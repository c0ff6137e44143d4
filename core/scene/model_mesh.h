#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer {

/// Returns the mesh of a model: that of its shape, or its own.
[[nodiscard]] Mesh meshOf(const Model& model);

/// The number of its vertices, without making the mesh.
[[nodiscard]] std::size_t vertexCountOf(const Model& model);

/// The parameters of the shape.
[[nodiscard]] ShapeOptions shapeOptions(const Model& model);

/// The number of corners of a primitive's parts: 1 for points, 2 for lines, 3 for all others.
[[nodiscard]] int partCorners(Primitive primitive);

/// The same for a model.
[[nodiscard]] int partCorners(const Model& model);

/// Whether the inner side of its faces is never visible, except for a gap under a teapot's lid.
[[nodiscard]] bool isClosed(const Model& model);

/// The model's own material if it has one, else the scene's. The shading model is always the scene's.
[[nodiscard]] const Material& materialOf(const Scene& scene, const Model& model);

} // namespace texplorer
