#include "texplorer/reference/shading/coordinate_reach.h"

#include "texplorer/reference/shading/coordinates.h"
#include "texplorer/scene/animation.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/emboss.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

glm::vec3 coordinateReach(const Scene& scene, std::size_t passIndex, std::size_t unit, double time) {
    const Pass& pass = scene.passes[passIndex];
    const Unit& state = pass.units[unit];
    glm::vec3 reach(0);
    for (const std::size_t index : drawnModels(scene, pass)) {
        const SentModel sent(scene.models[index]);
        const Model& model = *sent;
        const glm::mat4 matrix = coordinateMatrix(scene, passIndex, unit, index, LateFlip::None, time);
        const Mesh mesh = meshOf(model);
        const TexCoords given = givenTexCoords(scene, pass, static_cast<int>(unit), model, mesh, time);
        const EyeSpace eye(modelViewMatrix(scene.view, model, time));
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            const glm::vec4 coords =
                matrix * generatedCoordinates(state, LateFlip::None, given[v], eye(mesh.vertices[v]));
            for (int axis = 0; axis < 3; ++axis) {
                const float distance = std::abs(coords[axis] / coords.q);
                if (std::isfinite(distance))
                    reach[axis] = std::max(reach[axis], distance);
            }
        }
    }
    return reach;
}

} // namespace texplorer::reference
