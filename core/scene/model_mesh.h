#pragma once

#include "core/scene/scene.h"

namespace texplorer {

/// The mesh that a model is drawn as: that of its shape, or its own.
[[nodiscard]] Mesh meshOf(const Model& model);

/// How many vertices it has, without making it.
[[nodiscard]] std::size_t vertexCountOf(const Model& model);

/// What the shape is made from.
[[nodiscard]] ShapeOptions shapeOptions(const Model& model);

/// How many corners the parts of a primitive have: 1 of points, 2 of lines, 3 of all that become triangles.
[[nodiscard]] int partCorners(Primitive primitive);

/// The same of what a model is drawn as.
[[nodiscard]] int partCorners(const Model& model);

/// Whether one can't see the inner side of its faces, but for a gap under a teapot's lid.
[[nodiscard]] bool isClosed(const Model& model);

/// The model's own material where it has one, else the scene's. Its shading is always the scene's.
[[nodiscard]] const Material& materialOf(const Scene& scene, const Model& model);

} // namespace texplorer
