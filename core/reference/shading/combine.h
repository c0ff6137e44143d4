#pragma once

// GL_COMBINE: OpenGL 2.1, section 3.8.13, tables 3.23 to 3.25, with crossbar: an argument can be the texture
// colour of any unit.

#include "texplorer/gl/combine.h"
#include "texplorer/reference/shading/environment.h"

#include <span>

namespace texplorer::reference {

/// `textures` are the texture source colours of all units, for the crossbar. If one is missing (its unit is
/// off), the result is undefined: the incoming colour is returned.
[[nodiscard]] EnvironmentResult evaluate(const Combine& combine, const EnvironmentInputs& inputs,
                                         std::span<const glm::vec4* const> textures = {});

/// The same before the clamp to [0, 1].
[[nodiscard]] EnvironmentResult evaluateUnclamped(const Combine& combine, const EnvironmentInputs& inputs,
                                                  std::span<const glm::vec4* const> textures = {});

/// The equations of the colour and of alpha with their actual arguments: Cs and As of the texture, Cs2 of
/// unit 2's, Cp the incoming colour, Cf the primary colour, Cc the constant.
[[nodiscard]] EnvironmentEquations equationsOf(const Combine& combine, const EnvironmentInputs& inputs,
                                               std::span<const glm::vec4* const> textures = {});

} // namespace texplorer::reference
