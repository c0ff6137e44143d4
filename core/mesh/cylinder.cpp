#include "texplorer/mesh/shapes.h"

#include <glm/geometric.hpp>

#include <vector>

namespace texplorer {

// gluCylinder with the radius 1 below and a height of 2, turned as the sphere is and moved down by 1. Rows
// from the base up.
Mesh makeCylinder(float topRadius, int slices, int stacks) {
    std::vector<Ring> rings;
    const glm::vec2 slope = glm::normalize(glm::vec2(2, 1 - topRadius)); // outwards and up
    for (int stack = 0; stack <= stacks; ++stack) {
        const float share = static_cast<float>(stack) / static_cast<float>(stacks);
        rings.push_back({1 + share * (topRadius - 1), 2 * share - 1, slope});
    }

    Mesh mesh = turned(rings, slices);
    for (int stack = 0; stack < stacks; ++stack)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
