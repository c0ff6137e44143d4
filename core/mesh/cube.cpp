#include "texplorer/mesh/shapes.h"

namespace texplorer {

Mesh makeCube() {
    // Each face as seen from in front of it. The lids open towards the front: what is at the
    // upper edge of Top is the back, what lies at the upper edge of Bottom the front.
    Mesh mesh;
    addPatch(mesh, N_("Front"), {.lowerLeft = {-1, -1, 1}, .right = {2, 0, 0}, .up = {0, 2, 0}});
    addPatch(mesh, N_("Back"), {.lowerLeft = {1, -1, -1}, .right = {-2, 0, 0}, .up = {0, 2, 0}});
    addPatch(mesh, N_("Left"), {.lowerLeft = {-1, -1, -1}, .right = {0, 0, 2}, .up = {0, 2, 0}});
    // Translators: faces of a cube
    addPatch(mesh, N_("Right"), {.lowerLeft = {1, -1, 1}, .right = {0, 0, -2}, .up = {0, 2, 0}});
    addPatch(mesh, N_("Top"), {.lowerLeft = {-1, 1, 1}, .right = {2, 0, 0}, .up = {0, 0, -2}});
    addPatch(mesh, N_("Bottom"), {.lowerLeft = {-1, -1, -1}, .right = {2, 0, 0}, .up = {0, 0, 2}});
    return mesh;
}

} // namespace texplorer
