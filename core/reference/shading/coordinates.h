#pragma once

// From the coordinates that a vertex is given to those that its unit looks texels up with: OpenGL 2.1,
// sections 2.11.4 (generation) and 2.11.2 (texture matrix).

#include "core/mesh/mesh.h"
#include "core/reference/shading/tex_gen.h"
#include "core/texture/texture_levels.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace texplorer::reference {

/// From a model's vertices to eye coordinates.
class EyeSpace {
public:
    explicit EyeSpace(const glm::mat4& modelview);

    [[nodiscard]] GenerationInputs operator()(const Vertex& vertex) const;

private:
    glm::mat4 modelview_;
    glm::mat3 normal_; ///< the inverse transpose of modelview (section 2.11.3), but for a factor
};

/// t becomes q - t: upside down, as a matrix.
[[nodiscard]] glm::mat4 upsideDown();

/// What a unit multiplies by: GL_TEXTURE, and before it, where the picture is turned so, the flip.
[[nodiscard]] glm::mat4 coordinateMatrix(const Unit& unit, LateFlip flip, double time, const Light& light);

/// The coordinates before the matrix.
[[nodiscard]] glm::vec4 generatedCoordinates(const Unit& unit, LateFlip flip, glm::vec4 given,
                                             const GenerationInputs& inputs);

} // namespace texplorer::reference
