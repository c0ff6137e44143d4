#pragma once

// Fog: OpenGL 2.1, section 3.10.

#include "texplorer/reference/shading/environment.h"
#include "texplorer/scene/scene.h"

#include <glm/vec4.hpp>

#include <string>

namespace texplorer::reference {

/// f: the share of a fragment's colour that remains at a distance from the eye's plane, 0 to 1. NaN becomes
/// 0. Linear fog whose start equals its end is a step there, where the specification divides by 0.
[[nodiscard]] float fogFactor(const Fog& fog, float distance);

/// C = f * Cr + (1 - f) * Cf. Alpha stays.
[[nodiscard]] glm::vec4 fogged(glm::vec4 color, const Fog& fog, float factor);

/// The computation of f in symbols and in numbers, before the clamp: "f = e^(-(density * c))".
[[nodiscard]] Equation fogEquation(const Fog& fog, float distance);

} // namespace texplorer::reference
