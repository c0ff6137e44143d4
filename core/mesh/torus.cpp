#include "texplorer/mesh/shapes.h"

#include <vector>

namespace texplorer {

// A ring of radius 1 around our y axis. t begins where one looks least, at the inner equator, and goes down
// and outwards: 0.25 below, 0.5 at the outer equator, 0.75 above. Both seams have two vertices.
Mesh makeTorus(float tubeRadius, int slices, int stacks) {
    std::vector<Ring> rings;
    for (int stack = 0; stack <= stacks; ++stack) {
        const Circle tube = circleAt(4.0 * stack / stacks);
        rings.push_back({1 - tubeRadius * tube.cosine, -tubeRadius * tube.sine, {-tube.cosine, -tube.sine}});
    }

    Mesh mesh = turned(rings, slices);
    for (int stack = 0; stack < stacks; ++stack)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
