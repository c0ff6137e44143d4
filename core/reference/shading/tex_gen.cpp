#include "texplorer/reference/shading/tex_gen.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>

namespace texplorer::reference {

namespace {

TexGenMode acceptedMode(TexGenMode mode, int coordinate) {
    const auto& rows = coordinate == 3   ? texGenModesOfQ
                       : coordinate == 2 ? texGenModesOfR
                                         : std::span<const EnumRow>(texGenModeRows);
    for (const EnumRow& row : rows) {
        if (row.value == static_cast<std::uint32_t>(mode))
            return mode;
    }
    return TexGenMode::EyeLinear;
}

/// The sphere map of a direction that points straight away from the viewer has no place: it takes the middle.
float sphereMap(glm::vec3 r, int coordinate) {
    const float m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    return m > 0 ? r[coordinate] / m + 0.5F : 0.5F;
}

} // namespace

glm::vec3 reflectionVector(const GenerationInputs& inputs) {
    const glm::vec3 eye(inputs.eye);
    const float length = glm::length(eye);
    const glm::vec3 u = length > 0 && std::isfinite(length) ? eye / length : glm::vec3(0);
    return u - 2.0F * inputs.normal * glm::dot(inputs.normal, u);
}

glm::vec4 generateCoordinates(const Unit& unit, glm::vec4 given, const GenerationInputs& inputs) {
    const std::array<const TexGen*, 4> states{&unit.texGenS, &unit.texGenT, &unit.texGenR, &unit.texGenQ};
    glm::vec4 coords = given;
    for (int i = 0; i < 4; ++i) {
        const TexGen& state = *states[static_cast<std::size_t>(i)];
        if (!state.enabled)
            continue;
        switch (acceptedMode(state.mode, i)) {
        case TexGenMode::ObjectLinear:
            coords[i] = glm::dot(state.objectPlane, inputs.object);
            break;
        case TexGenMode::EyeLinear:
            coords[i] = glm::dot(state.eyePlane, inputs.eye);
            break;
        case TexGenMode::SphereMap:
            coords[i] = sphereMap(reflectionVector(inputs), i);
            break;
        case TexGenMode::ReflectionMap:
            coords[i] = reflectionVector(inputs)[i];
            break;
        case TexGenMode::NormalMap:
            coords[i] = inputs.normal[i];
            break;
        }
    }
    return coords;
}

} // namespace texplorer::reference
