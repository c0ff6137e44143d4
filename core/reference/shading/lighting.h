#pragma once

// Per-vertex lighting: OpenGL 2.1, section 2.14.1, with the one light of a Scene.

#include "texplorer/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace texplorer::reference {

/// The terms of the lighting equation at a vertex, before the clamp.
struct LightingTerms {
    glm::vec3 emission{0}; ///< of the material
    glm::vec3 scene{0};    ///< the material's ambient times the light model's
    glm::vec3 ambient{0};  ///< the material's ambient times the light's
    glm::vec3 diffuse{0};  ///< n . VP times the diffuse colours
    glm::vec3 specular{0}; ///< (n . h)^shininess times the specular colours
    float nDotVP = 0;      ///< 0 if the vertex faces away from the light
    float nDotH = 0;
};

/// The two colours of a vertex, clamped to [0, 1] (section 2.14.6). The secondary colour is black unless the
/// specular term is separate.
struct VertexColors {
    glm::vec4 primary{1};
    glm::vec3 secondary{0};
};

/// The surface parameters of the equation at a vertex. With GL_COLOR_MATERIAL, ambient and diffuse are the
/// current colour.
struct Reflectance {
    Reflectance(const Material& material, glm::vec4 currentColor);

    glm::vec3 ambient;
    glm::vec4 diffuse; ///< its alpha is the alpha of the primary colour
    glm::vec3 specular;
    glm::vec3 emission;
    float shininess;
};

/// `position` and `normal` are in eye coordinates; the normal has unit length.
[[nodiscard]] LightingTerms lightingTerms(const Light& light, const Reflectance& surface, glm::vec3 position,
                                          glm::vec3 normal);
[[nodiscard]] VertexColors litColors(const LightingTerms& terms, const Reflectance& surface,
                                     ColorControl control);

/// Without lighting, the primary colour is the current colour.
[[nodiscard]] VertexColors unlitColors(glm::vec4 currentColor);

} // namespace texplorer::reference
