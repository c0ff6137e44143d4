#include "texplorer/mesh/shapes.h"

#include <vector>

namespace texplorer {

// gluSphere turned so that its z axis is our y axis, with rows from the south pole up.
Mesh makeSphere(int slices, int stacks) {
    std::vector<Ring> rings;
    for (int stack = 0; stack <= stacks; ++stack) {
        const Circle latitude = circleAt(2.0 * stack / stacks); // from the south pole
        rings.push_back({latitude.sine, -latitude.cosine, {latitude.sine, -latitude.cosine}});
    }

    Mesh mesh = turned(rings, slices);
    // gluSphere's strips: from the north pole down, westwards. Where nothing hides what lies behind, the
    // order shows.
    for (int stack = stacks; stack-- > 0;)
        addBandQuads(mesh, slices, stack);
    return mesh;
}

} // namespace texplorer
