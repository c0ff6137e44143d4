#pragma once

// Coordinates that follow the light: NeHe's lesson 22, after J. Blinn, "Simulation of Wrinkled Surfaces"
// (1978). The same numbers for every renderer.

#include "core/scene/scene.h"

#include <vector>

namespace texplorer {

/// Along which directions of the model s and t grow at a vertex, of length 1; 0 where no triangle says so.
struct Tangents {
    glm::vec3 s{0};
    glm::vec3 t{0};
};

/// Of every vertex: the mean of its triangles.
[[nodiscard]] std::vector<Tangents> tangentsOf(const Mesh& mesh, const TexCoords& coords);

/// Where the light is as a model has it; with w = 0 a direction. The eye's place comes there by the inverse
/// of the modelview matrix, or by the transpose of its rotation and scale alone (LightCarrier).
[[nodiscard]] glm::vec4 lightInModel(const Scene& scene, const Model& model, LightCarrier carrier,
                                     double time);

/// How far (s, t) of a vertex move: (S . v, T . v) * depth, v being the direction from it to the light.
[[nodiscard]] glm::vec2 embossOffset(glm::vec3 position, const Tangents& tangents, glm::vec4 light,
                                     float depth);

/// The coordinates that a unit of a pass is given for a model, before generation: those of the model or its
/// mesh, moved where the unit embosses.
[[nodiscard]] TexCoords givenTexCoords(const Scene& scene, const Pass& pass, int unit, const Model& model,
                                       const Mesh& mesh, double time);

} // namespace texplorer
