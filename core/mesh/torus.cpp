#include "core/mesh/shapes.h"

namespace texplorer {

// A ring of radius 1 around our y axis, with the sphere's s. t begins where one looks least, at the inner
// equator, and goes down and outwards: 0.25 below, 0.5 at the outer equator, 0.75 above. Vertices lie in rows
// along s; both seams have two of them.
Mesh makeTorus(float tubeRadius, int slices, int stacks) {
    Mesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(slices + 1) * static_cast<std::size_t>(stacks + 1));
    for (int stack = 0; stack <= stacks; ++stack) {
        const Circle tube = circleAt(4.0 * stack / stacks);
        const float radius = 1 - tubeRadius * tube.cosine;
        for (int slice = 0; slice <= slices; ++slice) {
            const Circle longitude = circleAt(4.0 * slice / slices);
            const glm::vec3 point{-radius * longitude.sine, -tubeRadius * tube.sine,
                                  -radius * longitude.cosine};
            const glm::vec3 normal{tube.cosine * longitude.sine, -tube.sine, tube.cosine * longitude.cosine};
            const float s = static_cast<float>(slice) / static_cast<float>(slices);
            const float t = static_cast<float>(stack) / static_cast<float>(stacks);
            mesh.vertices.push_back({point, normal, {s, t, 0, 1}});
        }
    }

    addBandFaces(mesh, "Stack", slices, stacks);
    for (int stack = 0; stack < stacks; ++stack)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
