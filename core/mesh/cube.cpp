#include "texplorer/mesh/shapes.h"

namespace texplorer {

Mesh makeCube() {
    // Each face as seen from in front of it. The lids open towards the front: what is at the
    // upper edge of Top is the back, what lies at the upper edge of Bottom the front.
    Mesh mesh;
    addPatch(mesh, "Front", {.lowerLeft = {-1, -1, 1}, .right = {2, 0, 0}, .up = {0, 2, 0}});
    addPatch(mesh, "Back", {.lowerLeft = {1, -1, -1}, .right = {-2, 0, 0}, .up = {0, 2, 0}});
    addPatch(mesh, "Left", {.lowerLeft = {-1, -1, -1}, .right = {0, 0, 2}, .up = {0, 2, 0}});
    addPatch(mesh, "Right", {.lowerLeft = {1, -1, 1}, .right = {0, 0, -2}, .up = {0, 2, 0}});
    addPatch(mesh, "Top", {.lowerLeft = {-1, 1, 1}, .right = {2, 0, 0}, .up = {0, 0, -2}});
    addPatch(mesh, "Bottom", {.lowerLeft = {-1, -1, -1}, .right = {2, 0, 0}, .up = {0, 0, 2}});
    return mesh;
}

} // namespace texplorer
