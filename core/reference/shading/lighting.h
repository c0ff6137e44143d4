#pragma once

// Per-vertex lighting: OpenGL 2.1, section 2.14.1, with the one light that a Scene has.

#include "core/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace texplorer::reference {

/// The terms of the lighting equation at a vertex, each before the clamp.
struct LightingTerms {
    glm::vec3 emission{0}; ///< material's
    glm::vec3 scene{0};    ///< material's ambient times the light model's
    glm::vec3 ambient{0};  ///< times the light's
    glm::vec3 diffuse{0};  ///< n . VP times the diffuse colours
    glm::vec3 specular{0}; ///< (n . h)^shininess times the specular colours
    float nDotVP = 0;      ///< 0 where the vertex faces away
    float nDotH = 0;
};

/// The two colours of a vertex, clamped to [0, 1] (section 2.14.6). The secondary one is black unless the
/// specular term is kept apart.
struct VertexColors {
    glm::vec4 primary{1};
    glm::vec3 secondary{0};
};

/// What of a surface the equation needs at a vertex. Under GL_COLOR_MATERIAL the current colour is the
/// ambient and the diffuse reflectance.
struct Reflectance {
    Reflectance(const Material& material, glm::vec4 currentColor);

    glm::vec3 ambient;
    glm::vec4 diffuse; ///< its alpha is that of the primary colour
    glm::vec3 specular;
    glm::vec3 emission;
    float shininess;
};

/// `position` and `normal` in eye coordinates; the normal of unit length.
[[nodiscard]] LightingTerms lightingTerms(const Light& light, const Reflectance& surface, glm::vec3 position,
                                          glm::vec3 normal);
[[nodiscard]] VertexColors litColors(const LightingTerms& terms, const Reflectance& surface,
                                     ColorControl control);

/// Without lighting the current colour is the primary one.
[[nodiscard]] VertexColors unlitColors(glm::vec4 currentColor);

} // namespace texplorer::reference
