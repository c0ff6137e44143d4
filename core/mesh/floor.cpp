#include "texplorer/mesh/shapes.h"

namespace texplorer {

Mesh makeFloor() {
    Mesh mesh;
    addPatch(
        mesh, N_("Floor"),
        {.lowerLeft = {-4, -1, 4}, .right = {8, 0, 0}, .up = {0, 0, -80}, .texUpperRight = {8, 80, 0, 1}});
    return mesh;
}

} // namespace texplorer
