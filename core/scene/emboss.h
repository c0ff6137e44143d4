#pragma once

// Coordinates that are moved towards the light: NeHe's lesson 22, after J. Blinn, "Simulation of Wrinkled
// Surfaces" (1978). The numbers are the same for every renderer.

#include "texplorer/scene/scene.h"

#include <vector>

namespace texplorer {

/// The directions of increasing s and t at a vertex, in the model's space, of length 1; 0 if no triangle
/// defines them.
struct Tangents {
    glm::vec3 s{0};
    glm::vec3 t{0};
};

/// For every vertex: the mean of its triangles.
[[nodiscard]] std::vector<Tangents> tangentsOf(const Mesh& mesh, const TexCoords& coords);

/// The light's position in the model's space; with w = 0 a direction. It is transformed by the inverse of the
/// modelview matrix, or by the transpose of its rotation and scale only (LightCarrier).
[[nodiscard]] glm::vec4 lightInModel(const Scene& scene, const Model& model, LightCarrier carrier,
                                     double time);

/// The offset of (s, t) at a vertex: (S . v, T . v) * depth, where v is the direction from it to the light.
[[nodiscard]] glm::vec2 embossOffset(glm::vec3 position, const Tangents& tangents, glm::vec4 light,
                                     float depth);

/// The coordinates of a model for a unit of a pass, before generation: those of the model or its mesh, moved
/// if the unit embosses.
[[nodiscard]] TexCoords givenTexCoords(const Scene& scene, const Pass& pass, int unit, const Model& model,
                                       const Mesh& mesh, double time);

} // namespace texplorer
