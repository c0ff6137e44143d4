#pragma once

// GL_COMBINE: OpenGL 2.1, section 3.8.13, tables 3.23 to 3.25, with crossbar: an argument may be the texture
// colour of any unit.

#include "core/gl/combine.h"
#include "core/reference/environment.h"

#include <span>

namespace texplorer::reference {

/// `textures` are the texture source colours of all units, for the crossbar; one that is not there (its unit
/// is off) makes the result undefined: the incoming colour is passed on.
[[nodiscard]] EnvironmentResult evaluate(const Combine& combine, const EnvironmentInputs& inputs,
                                         std::span<const glm::vec4* const> textures = {});

} // namespace texplorer::reference
