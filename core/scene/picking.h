#pragma once

#include "core/scene/scene.h"

#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <vector>

namespace texplorer {

// Points in a picture are fractions of it: (0, 0) is its top left corner, (1, 1) the bottom right one.

struct PickedVertex {
    std::size_t model;  ///< index into Scene::models
    std::size_t vertex; ///< index into the vertices of its mesh

    bool operator==(const PickedVertex&) const = default;
};

/// How far from a vertex one may click, as a fraction of the picture's height.
inline constexpr float pickRadius = 0.03F;

/// Where a vertex is in the picture, which may be outside of it. Nothing where it lies outside of the near
/// and far planes, or where there is no such vertex. `aspect` is width / height of the picture.
[[nodiscard]] std::optional<glm::vec2> projectVertex(const Scene& scene, std::size_t model,
                                                     std::size_t vertex, double time, float aspect);

/// The same of several vertices of a model, whose mesh this is.
[[nodiscard]] std::vector<std::optional<glm::vec2>> projectVertices(const Scene& scene, const Model& model,
                                                                    const Mesh& mesh,
                                                                    std::span<const std::size_t> vertices,
                                                                    double time, float aspect);

/// The vertex nearest to a point, within `radius`, that one sees: on a visible model, not on the far side of
/// its own cube or sphere, not behind another model. Where several coincide, as at a corner of the cube, it
/// is the one whose face looks most towards the viewer.
[[nodiscard]] std::optional<PickedVertex> pickVertex(const Scene& scene, double time, float aspect,
                                                     glm::vec2 point, float radius = pickRadius);

} // namespace texplorer
