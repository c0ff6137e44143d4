#pragma once

// From a vertex's texture coordinates to those that its unit samples at: OpenGL 2.1, sections 2.11.4
// (generation) and 2.11.2 (texture matrix).

#include "texplorer/mesh/mesh.h"
#include "texplorer/reference/shading/tex_gen.h"
#include "texplorer/texture/texture_levels.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <vector>

namespace texplorer::reference {

/// Transforms a model's vertices to eye coordinates.
class EyeSpace {
public:
    explicit EyeSpace(const glm::mat4& modelview);

    [[nodiscard]] GenerationInputs operator()(const Vertex& vertex) const;

private:
    glm::mat4 modelview_;
    glm::mat3 normal_; ///< the inverse transpose of modelview (section 2.11.3), up to a factor
};

/// The matrix that flips an image: t becomes q - t.
[[nodiscard]] glm::mat4 upsideDown();

/// The matrix that a unit has when a pass draws a model: GL_TEXTURE, after the flip if the image is flipped
/// by the matrix.
[[nodiscard]] glm::mat4 coordinateMatrix(const Scene& scene, std::size_t pass, std::size_t unit,
                                         std::size_t model, LateFlip flip, double time);

/// The same for each model of the scene; the identity for those that the pass does not draw.
[[nodiscard]] std::vector<glm::mat4> coordinateMatrices(const Scene& scene, std::size_t pass,
                                                        std::size_t unit, LateFlip flip, double time);

/// The coordinates before the matrix.
[[nodiscard]] glm::vec4 generatedCoordinates(const Unit& unit, LateFlip flip, glm::vec4 given,
                                             const GenerationInputs& inputs);

} // namespace texplorer::reference
