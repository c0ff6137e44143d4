#include "texplorer/reference/shading/lighting.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

/// The unit vector in a direction; a vector without one stays zero.
glm::vec3 direction(glm::vec3 v) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0);
}

} // namespace

Reflectance::Reflectance(const Material& material, glm::vec4 currentColor)
    : ambient(material.colorMaterial ? currentColor : material.ambient)
    , diffuse(material.colorMaterial ? currentColor : material.diffuse)
    , specular(material.specular)
    , emission(material.emission)
    , shininess(material.shininess) {}

LightingTerms lightingTerms(const Light& light, const Reflectance& surface, glm::vec3 position,
                            glm::vec3 normal) {
    // VP: to a light at a place or, with w = 0, at infinity.
    const glm::vec3 toLight =
        direction(light.position.w == 0 ? glm::vec3(light.position)
                                        : glm::vec3(light.position) / light.position.w - position);
    const glm::vec3 toViewer = light.localViewer ? direction(-position) : glm::vec3(0, 0, 1);

    LightingTerms terms;
    terms.emission = surface.emission;
    terms.scene = surface.ambient * glm::vec3(light.modelAmbient);
    terms.ambient = surface.ambient * glm::vec3(light.ambient);
    terms.nDotVP = std::max(0.0F, glm::dot(normal, toLight));
    terms.diffuse = terms.nDotVP * glm::vec3(surface.diffuse) * glm::vec3(light.diffuse);
    if (terms.nDotVP > 0) { // f_i
        terms.nDotH = std::max(0.0F, glm::dot(normal, direction(toLight + toViewer)));
        // pow(0, 0) is 1, as in the specification.
        terms.specular =
            std::pow(terms.nDotH, surface.shininess) * surface.specular * glm::vec3(light.specular);
    }
    return terms;
}

VertexColors litColors(const LightingTerms& terms, const Reflectance& surface, ColorControl control) {
    const bool apart = control == ColorControl::SeparateSpecular;
    const glm::vec3 primary = terms.emission + terms.scene + terms.ambient + terms.diffuse +
                              (apart ? glm::vec3(0) : terms.specular);
    return {glm::clamp(glm::vec4(primary, surface.diffuse.a), 0.0F, 1.0F),
            apart ? glm::clamp(terms.specular, 0.0F, 1.0F) : glm::vec3(0)};
}

VertexColors unlitColors(glm::vec4 currentColor) {
    return {glm::clamp(currentColor, 0.0F, 1.0F), glm::vec3(0)};
}

} // namespace texplorer::reference
