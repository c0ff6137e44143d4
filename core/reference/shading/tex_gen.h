#pragma once

// Generated texture coordinates: OpenGL 2.1, section 2.11.4.

#include "texplorer/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace texplorer::reference {

/// The inputs of generation. The normal is in eye coordinates and has unit length.
struct GenerationInputs {
    glm::vec4 object{0, 0, 0, 1};
    glm::vec4 eye{0, 0, 0, 1};
    glm::vec3 normal{0};
};

/// The reflection vector r = u - 2 n (n . u), where u points from the eye to the vertex.
[[nodiscard]] glm::vec3 reflectionVector(const GenerationInputs& inputs);

/// Returns `given` with the coordinates that the unit generates replaced. A mode that GL refuses for a
/// coordinate (a sphere map for r) leaves GL's initial mode, GL_EYE_LINEAR.
[[nodiscard]] glm::vec4 generateCoordinates(const Unit& unit, glm::vec4 given,
                                            const GenerationInputs& inputs);

} // namespace texplorer::reference
