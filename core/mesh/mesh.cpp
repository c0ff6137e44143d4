#include "core/mesh/mesh.h"

#include "core/mesh/shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace texplorer {

namespace {

int clampSlices(int slices) {
    return std::clamp(slices, minSlices, maxSubdivision);
}
int clampStacks(int stacks) {
    return std::clamp(stacks, minStacks, maxSubdivision);
}

} // namespace

void addQuad(Mesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    for (const std::size_t corner : {0U, 1U, 3U, 1U, 2U, 3U})
        mesh.triangles.push_back(corners[corner]);
}

void addPatch(Mesh& mesh, std::string name, const Patch& patch) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec3 normal = glm::normalize(glm::cross(patch.right, patch.up));
    const glm::vec4& low = patch.texLowerLeft;
    const glm::vec4& high = patch.texUpperRight;

    mesh.vertices.push_back({patch.lowerLeft, normal, low});
    mesh.vertices.push_back({patch.lowerLeft + patch.right, normal, {high.s, low.t, low.p, low.q}});
    mesh.vertices.push_back({patch.lowerLeft + patch.right + patch.up, normal, high});
    mesh.vertices.push_back({patch.lowerLeft + patch.up, normal, {low.s, high.t, low.p, low.q}});
    addQuad(mesh, {first, first + 1, first + 2, first + 3});
    mesh.faces.push_back({std::move(name), {first, first + 1, first + 2, first + 3}});
}

Mesh makeMesh(Shape shape, int slices, int stacks) {
    switch (shape) {
    case Shape::Cube:
        return makeCube();
    case Shape::Sphere:
        return makeSphere(clampSlices(slices), clampStacks(stacks));
    case Shape::Quad:
        return makeQuad();
    case Shape::Floor:
        return makeFloor();
    }
    return {};
}

std::size_t vertexCount(Shape shape, int slices, int stacks) {
    switch (shape) {
    case Shape::Cube:
        return 24;
    case Shape::Sphere:
        return static_cast<std::size_t>(clampSlices(slices) + 1) *
               static_cast<std::size_t>(clampStacks(stacks) + 1);
    case Shape::Quad:
    case Shape::Floor:
        return 4;
    }
    return 0;
}

} // namespace texplorer
