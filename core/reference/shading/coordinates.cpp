#include "texplorer/reference/shading/coordinates.h"

#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/texture_matrix.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace texplorer::reference {

namespace {

/// The cofactors: the inverse transpose but for a factor, which GL_NORMALIZE takes away again. They exist for
/// a model of size 0, too.
glm::mat3 cofactors(const glm::mat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

glm::vec3 normalized(glm::vec3 v) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0);
}

} // namespace

EyeSpace::EyeSpace(const glm::mat4& modelview)
    : modelview_(modelview)
    , normal_(cofactors(glm::mat3(modelview))) {
    if (glm::dot(normal_[0], glm::vec3(modelview[0])) < 0) // a model of negative size is mirrored
        normal_ *= -1.0F;
}

GenerationInputs EyeSpace::operator()(const Vertex& vertex) const {
    const glm::vec4 position(vertex.position, 1);
    return {position, modelview_ * position, normalized(normal_ * vertex.normal)};
}

glm::mat4 upsideDown() {
    return glm::scale(glm::translate(glm::mat4(1), {0, 1, 0}), {1, -1, 1});
}

glm::mat4 coordinateMatrix(const Scene& scene, std::size_t pass, std::size_t unit, std::size_t model,
                           LateFlip flip, double time) {
    const glm::mat4 matrix = textureMatrix(scene, pass, unit, model, time);
    return flip == LateFlip::Matrix ? upsideDown() * matrix : matrix;
}

std::vector<glm::mat4> coordinateMatrices(const Scene& scene, std::size_t pass, std::size_t unit,
                                          LateFlip flip, double time) {
    std::vector<glm::mat4> matrices(scene.models.size(), glm::mat4(1));
    for (const std::size_t model : drawnModels(scene, scene.passes[pass]))
        matrices[model] = coordinateMatrix(scene, pass, unit, model, flip, time);
    return matrices;
}

glm::vec4 generatedCoordinates(const Unit& unit, LateFlip flip, glm::vec4 given,
                               const GenerationInputs& inputs) {
    if (flip == LateFlip::Coordinates)
        given.t = given.q - given.t;
    return generateCoordinates(unit, given, inputs);
}

} // namespace texplorer::reference
