#include "texplorer/reference/shading/fog.h"

#include "texplorer/reference/shading/equation_text.h"

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace texplorer::reference {

namespace {

float unclampedFogFactor(const Fog& fog, float distance) {
    const float thickness = fog.density * distance;
    switch (fog.mode) {
    case FogMode::Linear:
        return (fog.end - distance) / (fog.end - fog.start);
    case FogMode::Exp:
        return std::exp(-thickness);
    case FogMode::Exp2:
        return std::exp(-(thickness * thickness));
    }
    return 1;
}

constexpr std::string_view fogSymbols(FogMode mode) {
    switch (mode) {
    case FogMode::Linear:
        return N_("(end - c) / (end - start)");
    case FogMode::Exp:
        return N_("e^(-density * c)");
    case FogMode::Exp2:
        return N_("e^(-(density * c)^2)");
    }
    return {};
}

} // namespace

float fogFactor(const Fog& fog, float distance) {
    const float factor = unclampedFogFactor(fog, distance);
    return factor > 0 ? std::min(factor, 1.0F) : 0;
}

glm::vec4 fogged(glm::vec4 color, const Fog& fog, float factor) {
    const glm::vec3 fogColor = glm::clamp(glm::vec3(fog.color), 0.0F, 1.0F);
    return {glm::vec3(color) * factor + fogColor * (1 - factor), color.a};
}

Equation fogEquation(const Fog& fog, float distance) {
    const std::string_view term = fogSymbols(fog.mode);
    const std::string numbers =
        inNumbers(term, {{"density", fog.density}, {"start", fog.start}, {"end", fog.end}, {"c", distance}});
    return {fmt::format("f = {}", term),
            {fmt::format("{} = {}", numbers, shortNumber(unclampedFogFactor(fog, distance)))}};
}

} // namespace texplorer::reference
