#include "texplorer/scene/picking.h"

#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/mesh_edits.h"
#include "texplorer/scene/model_mesh.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer {
namespace {

/// Vertices closer together than this, as a fraction of the height, count as one spot: half a pixel of 1000.
constexpr float sameSpot = 0.0005F;

/// How many vertices around the point are tried for one that nothing hides.
constexpr std::size_t maxCandidates = 64;

std::optional<glm::vec2> project(const glm::mat4& matrix, glm::vec3 position) {
    const glm::vec4 clip = matrix * glm::vec4(position, 1);
    if (!(clip.w > 0) || std::abs(clip.z) > clip.w)
        return std::nullopt;
    return glm::vec2(0.5F + 0.5F * clip.x / clip.w, 0.5F - 0.5F * clip.y / clip.w);
}

glm::mat4 cameraMatrix(const View& view, float aspect) {
    return projectionMatrix(view, aspect) * viewMatrix(view);
}

/// From a point of the scene towards the viewer.
struct Sight {
    glm::vec3 from;
    glm::vec3 way;
    float length; ///< in multiples of `way`: where the viewer is
};

class Viewer {
public:
    explicit Viewer(const View& view)
        : parallel_(view.projection == Projection::Orthographic) {
        const glm::mat4 toScene = glm::inverse(viewMatrix(view));
        eye_ = glm::vec3(toScene[3]);
        back_ = glm::vec3(toScene[2]);
    }

    Sight sightOf(glm::vec3 point) const {
        if (parallel_)
            return {point, back_, INFINITY};
        return {point, eye_ - point, 1};
    }

private:
    bool parallel_;
    glm::vec3 eye_{};
    glm::vec3 back_{};
};

/// Whether a triangle crosses a line of sight (Moeller and Trumbore).
bool crosses(const Sight& sight, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::vec3 ab = b - a;
    const glm::vec3 ac = c - a;
    const glm::vec3 normal = glm::cross(sight.way, ac);
    const float determinant = glm::dot(ab, normal);
    if (determinant == 0)
        return false;
    const glm::vec3 offset = sight.from - a;
    const float u = glm::dot(offset, normal) / determinant;
    const glm::vec3 across = glm::cross(offset, ab);
    const float v = glm::dot(sight.way, across) / determinant;
    if (u < 0 || v < 0 || u + v > 1)
        return false;
    constexpr float touching = 1e-4F; // models that touch don't hide each other's vertices
    const float at = glm::dot(ac, across) / determinant;
    return at > touching && at < sight.length;
}

/// A model with what the search needs of it.
struct Placed {
    std::size_t index;
    bool closed; ///< one can't see the inner side of its faces
    glm::mat4 toScene;
    const MeshData* file; ///< triangles of a file, of which no mesh is made; nullptr: it has a mesh
    Mesh mesh;
    glm::mat3 normals = glm::transpose(glm::inverse(glm::mat3(toScene)));
};

/// Calls `visit` with the number, position and normal of each vertex.
void eachVertex(const Placed& placed, const auto& visit) {
    for (std::size_t v = 0; placed.file && v < placed.file->positions.size(); ++v)
        visit(v, placed.file->positions[v], givenNormal(*placed.file, v));
    for (std::size_t v = 0; v < placed.mesh.vertices.size(); ++v)
        visit(v, placed.mesh.vertices[v].position, placed.mesh.vertices[v].normal);
}

bool hides(const Placed& placed, const Sight& sight) {
    const glm::mat4 toModel = glm::inverse(placed.toScene);
    const Sight local{glm::vec3(toModel * glm::vec4(sight.from, 1)),
                      glm::vec3(toModel * glm::vec4(sight.way, 0)), sight.length};
    if (placed.file) {
        const auto at = [&](std::size_t i) {
            return placed.file->positions[static_cast<std::size_t>(placed.file->indices[i])];
        };
        for (std::size_t i = 0; i + 2 < placed.file->indices.size(); i += 3)
            if (crosses(local, at(i), at(i + 1), at(i + 2)))
                return true;
    }
    const auto& vertices = placed.mesh.vertices;
    const auto& triangles = placed.mesh.triangles;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        if (crosses(local, vertices[triangles[i]].position, vertices[triangles[i + 1]].position,
                    vertices[triangles[i + 2]].position))
            return true;
    return false;
}

struct Candidate {
    PickedVertex picked;
    float distance; ///< from the point, as a fraction of the height
    float facing;   ///< cosine between the normal and the way to the viewer
    Sight sight;
};

} // namespace

std::optional<glm::vec2> projectVertex(const Scene& scene, std::size_t model, std::size_t vertex, double time,
                                       float aspect) {
    if (model >= scene.models.size())
        return std::nullopt;
    const Model& placed = scene.models[model];
    return projectVertices(scene, placed, meshOf(placed), {&vertex, 1}, time, aspect).front();
}

std::vector<std::optional<glm::vec2>> projectVertices(const Scene& scene, const Model& model,
                                                      const Mesh& mesh, std::span<const std::size_t> vertices,
                                                      double time, float aspect) {
    const glm::mat4 toClip = projectionMatrix(scene.view, aspect) * modelViewMatrix(scene.view, model, time);
    std::vector<std::optional<glm::vec2>> places;
    for (const std::size_t vertex : vertices)
        places.push_back(vertex < mesh.vertices.size() ? project(toClip, mesh.vertices[vertex].position)
                                                       : std::nullopt);
    return places;
}

std::optional<PickedVertex> pickVertex(const Scene& scene, double time, float aspect, glm::vec2 point,
                                       float radius) {
    const glm::mat4 camera = cameraMatrix(scene.view, aspect);
    const Viewer viewer(scene.view);

    std::vector<Placed> models;
    const glm::mat4 fromEye = glm::inverse(viewMatrix(scene.view));
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        if (!isInWindow(scene, i))
            continue;
        const Model& model = scene.models[i];
        const glm::mat4 placed = modelMatrix(model, time);
        const bool isFile = model.shape == Shape::Mesh && !model.mesh.file.empty() &&
                            model.mesh.primitive == Primitive::Triangles;
        models.push_back({i, isClosed(model), model.attachment == Attachment::Eye ? fromEye * placed : placed,
                          isFile ? &model.mesh : nullptr, isFile ? Mesh{} : meshOf(model)});
    }

    std::vector<Candidate> candidates;
    for (const Placed& placed : models) {
        const glm::mat4 toClip = camera * placed.toScene;
        eachVertex(placed, [&](std::size_t v, glm::vec3 position, glm::vec3 given) {
            const auto spot = project(toClip, position);
            if (!spot)
                return;
            const float distance = glm::length((*spot - point) * glm::vec2(aspect, 1));
            if (!(distance <= radius))
                return;
            const Sight sight = viewer.sightOf(glm::vec3(placed.toScene * glm::vec4(position, 1)));
            const glm::vec3 normal = glm::normalize(placed.normals * given);
            const float facing = glm::dot(normal, glm::normalize(sight.way));
            if (facing > 0 || !placed.closed)
                candidates.push_back({{placed.index, v}, distance, std::abs(facing), sight});
        });
    }
    std::ranges::sort(candidates, {}, &Candidate::distance);
    candidates.resize(std::min(candidates.size(), maxCandidates), Candidate{});

    const Candidate* best = nullptr;
    float nearest = 0;
    for (const Candidate& candidate : candidates) {
        if (best && candidate.distance > nearest + sameSpot)
            break;
        if (best && candidate.facing <= best->facing)
            continue;
        const bool hidden = std::ranges::any_of(models, [&](const Placed& other) {
            return other.index != candidate.picked.model && hides(other, candidate.sight);
        });
        if (hidden)
            continue;
        if (!best)
            nearest = candidate.distance;
        best = &candidate;
    }
    return best ? std::optional(best->picked) : std::nullopt;
}

} // namespace texplorer
