#include "texplorer/reference/raster/shade.h"

#include "texplorer/reference/sampling/sampler.h"
#include "texplorer/reference/shading/combine.h"
#include "texplorer/reference/shading/environment.h"
#include "texplorer/reference/shading/fog.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::reference {

TexturePlace texturePlace(const Triangle& triangle, std::size_t unit, glm::vec2 offset) {
    // Both s and q are over w: their quotient is that of the coordinates. (s / q)' = (s' - (s / q) q') / q
    const Plane<glm::vec4>& plane = triangle.texCoords[unit];
    const glm::vec4 overW = plane.at(offset);
    TexturePlace place;
    place.homogeneous = overW / triangle.invW.at(offset);
    place.coords = glm::vec3(overW) / overW.q;
    place.derivatives.dx = (glm::vec3(plane.dx) - place.coords * plane.dx.q) / overW.q;
    place.derivatives.dy = (glm::vec3(plane.dy) - place.coords * plane.dy.q) / overW.q;
    return place;
}

glm::vec4 primaryColor(const Triangle& triangle, glm::vec2 offset) {
    // A pixel's centre can be just outside of the unsnapped triangle, so the colour is clamped.
    if (triangle.evenPrimary)
        return glm::clamp(*triangle.evenPrimary, 0.0F, 1.0F);
    return glm::clamp(triangle.primary.at(offset) * (1 / triangle.invW.at(offset)), 0.0F, 1.0F);
}

glm::vec4 summedColor(const Triangle& triangle, glm::vec2 offset) {
    const PassState& pass = *triangle.pass;
    const glm::vec4 primary = primaryColor(triangle, offset);
    // All samples first: COMBINE may ask for that of any unit.
    std::array<glm::vec4, maxUnits> samples{};
    std::array<const glm::vec4*, maxUnits> sources{};
    for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
        const UnitState& unit = pass.units[u];
        if (!unit.texture)
            continue;
        const TexturePlace place = texturePlace(triangle, u, offset);
        samples[u] = sample(*unit.texture, place.coords, place.derivatives, unit.sampling);
        sources[u] = &samples[u];
    }
    glm::vec4 color = primary;
    for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
        const UnitState& unit = pass.units[u];
        if (!unit.texture)
            continue;
        const EnvironmentInputs inputs{color, samples[u], unit.envColor, primary};
        color = (unit.unit->envMode == EnvMode::Combine
                     ? evaluate(unit.unit->combine, inputs, sources)
                     : evaluate(unit.unit->envMode, unit.texture->format, inputs))
                    .color;
    }
    if (pass.separateSpecular) // section 3.9: alpha stays
        color += glm::clamp(triangle.secondary.at(offset) * (1 / triangle.invW.at(offset)), 0.0F, 1.0F);
    return glm::clamp(color, 0.0F, 1.0F);
}

float fogDistance(const Triangle& triangle, glm::vec2 offset) {
    return triangle.fogDistance.at(offset) * (1 / triangle.invW.at(offset));
}

glm::vec4 fragmentColor(const Triangle& triangle, glm::vec2 offset) {
    const glm::vec4 color = summedColor(triangle, offset);
    const Fog* fog = triangle.pass->fog;
    return fog ? fogged(color, *fog, fogFactor(*fog, fogDistance(triangle, offset))) : color;
}

std::uint32_t fragmentDepth(const Triangle& triangle, glm::vec2 offset) {
    const float depth = triangle.depth.at(offset);
    return static_cast<std::uint32_t>(
        std::lround(double{depth > 0 ? std::min(depth, 1.0F) : 0} * farthestDepth));
}

} // namespace texplorer::reference
