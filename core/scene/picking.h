#pragma once

#include "texplorer/scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <vector>

namespace texplorer {

// Positions in a picture are fractions of its size: (0, 0) is its top left corner, (1, 1) the bottom right
// one.

struct PickedVertex {
    std::size_t model;  ///< index into Scene::models
    std::size_t vertex; ///< index into the vertices of its mesh

    bool operator==(const PickedVertex&) const = default;
};

/// The maximum distance of a click from a vertex, as a fraction of the picture's height.
inline constexpr float pickRadius = 0.03F;

/// The position of a vertex in the picture, which can be outside of it. Empty if the vertex is outside of the
/// near and far planes or does not exist. `aspect` is width / height of the picture.
[[nodiscard]] std::optional<glm::vec2> projectVertex(const Scene& scene, std::size_t model,
                                                     std::size_t vertex, double time, float aspect);

/// The same for several vertices of a model with this mesh.
[[nodiscard]] std::vector<std::optional<glm::vec2>> projectVertices(const Scene& scene, const Model& model,
                                                                    const Mesh& mesh,
                                                                    std::span<const std::size_t> vertices,
                                                                    double time, float aspect);

/// The nearest visible vertex within `radius`: on a visible model, not on the far side of its own cube or
/// sphere, not behind another model. If several are at the same position, as at a corner of the cube, the one
/// whose face is turned most towards the viewer.
[[nodiscard]] std::optional<PickedVertex> pickVertex(const Scene& scene, double time, float aspect,
                                                     glm::vec2 point, float radius = pickRadius);

} // namespace texplorer
