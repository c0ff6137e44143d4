#pragma once

// Per-vertex lighting: OpenGL 2.1, section 2.14.1, with the one light and material that a Scene has.

#include "core/scene/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace texplorer::reference {

/// The terms of the lighting equation at a vertex, each before the clamp.
struct LightingTerms {
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

/// `position` and `normal` in eye coordinates; the normal of unit length.
[[nodiscard]] LightingTerms lightingTerms(const Light& light, const Material& material, glm::vec3 position,
                                          glm::vec3 normal);
[[nodiscard]] VertexColors litColors(const LightingTerms& terms, const Material& material,
                                     ColorControl control);

/// Without lighting the current colour is the primary one.
[[nodiscard]] VertexColors unlitColors(const Material& material);

} // namespace texplorer::reference
