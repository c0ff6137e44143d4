#include "core/mesh/shapes.h"

namespace texplorer {

// gluSphere turned so that its z axis is our y axis: s = 0 at the back (-z), growing eastwards over the left
// (-x, 0.25), the front (0.5) and the right (0.75). Vertices lie in rows from the south pole up; the seam and
// the poles have a vertex for each s, because one position there needs several texture coordinates.
Mesh makeSphere(int slices, int stacks) {
    Mesh mesh;
    mesh.vertices.reserve(static_cast<std::size_t>(slices + 1) * static_cast<std::size_t>(stacks + 1));
    for (int stack = 0; stack <= stacks; ++stack) {
        const Circle latitude = circleAt(2.0 * stack / stacks); // from the south pole
        for (int slice = 0; slice <= slices; ++slice) {
            const Circle longitude = circleAt(4.0 * slice / slices);
            const glm::vec3 point{-latitude.sine * longitude.sine, -latitude.cosine,
                                  -latitude.sine * longitude.cosine};
            const float s = static_cast<float>(slice) / static_cast<float>(slices);
            const float t = static_cast<float>(stack) / static_cast<float>(stacks);
            mesh.vertices.push_back({point, point, {s, t, 0, 1}});
        }
    }

    addBandFaces(mesh, "Stack", slices, stacks);
    // gluSphere's strips: from the north pole down, westwards. Where nothing hides what lies behind, the
    // order shows.
    for (int stack = stacks; stack-- > 0;)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
