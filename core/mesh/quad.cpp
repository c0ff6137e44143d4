#include "texplorer/mesh/shapes.h"

namespace texplorer {

Mesh makeQuad() {
    Mesh mesh;
    addPatch(mesh, N_("Front"), {.lowerLeft = {-1, -1, 0}, .right = {2, 0, 0}, .up = {0, 2, 0}});
    return mesh;
}

} // namespace texplorer
