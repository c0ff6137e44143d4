#include "app/ui/model/tex_coord_edits.h"

namespace texplorer::ui {

void scaleCoords(TexCoords& coords, float factor) {
    for (glm::vec4& each : coords) {
        each.x *= factor;
        each.y *= factor;
    }
}

void flipS(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each.x = 1 - each.x;
}

void flipT(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each.y = 1 - each.y;
}

void rotateQuarter(TexCoords& coords) {
    for (glm::vec4& each : coords)
        each = {1 - each.y, each.x, each.z, each.w};
}

} // namespace texplorer::ui
