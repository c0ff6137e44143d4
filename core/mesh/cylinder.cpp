#include "core/mesh/shapes.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace texplorer {

// gluCylinder with the radius 1 below and a height of 2, turned as the sphere is and moved down by 1.
// Vertices lie in rows from the base up; the seam has two of them, and the tip of a cone one for each s.
Mesh makeCylinder(float topRadius, int slices, int stacks) {
    Mesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(slices + 1) * static_cast<std::size_t>(stacks + 1));
    const glm::vec2 slope = glm::normalize(glm::vec2(2, 1 - topRadius)); // outwards and up
    for (int stack = 0; stack <= stacks; ++stack) {
        const float t = static_cast<float>(stack) / static_cast<float>(stacks);
        const float radius = std::lerp(1.0F, topRadius, t);
        for (int slice = 0; slice <= slices; ++slice) {
            const Circle longitude = circleAt(4.0 * slice / slices);
            const glm::vec3 point{-radius * longitude.sine, 2 * t - 1, -radius * longitude.cosine};
            const glm::vec3 normal{-slope.x * longitude.sine, slope.y, -slope.x * longitude.cosine};
            const float s = static_cast<float>(slice) / static_cast<float>(slices);
            mesh.vertices.push_back({point, normal, {s, t, 0, 1}});
        }
    }

    addBandFaces(mesh, "Stack", slices, stacks);
    for (int stack = 0; stack < stacks; ++stack)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
