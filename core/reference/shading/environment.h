#pragma once

// The texture environment: OpenGL 2.1, section 3.8.13.

#include "texplorer/base/sentence.h"
#include "texplorer/gl/environment.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace texplorer::reference {

/// The inputs of an environment, each clamped to [0, 1].
struct EnvironmentInputs {
    glm::vec4 previous{
        1};              ///< Cp, Ap: the colour of the previous unit; for unit 0 the primary colour (Cf, Af)
    glm::vec4 source{1}; ///< Cs, As: the texture source colour (table 3.20)
    glm::vec4 constant{0}; ///< Cc, Ac: GL_TEXTURE_ENV_COLOR
    glm::vec4 primary{1};  ///< Cf, Af: used only by COMBINE
};

struct EnvironmentResult {
    glm::vec4 color{0};
    /// The specification leaves this combination undefined; the incoming colour is returned.
    bool undefined = false;
};

/// All functions of tables 3.21 and 3.22, for a colour component or for alpha.
enum class EnvFunction : std::uint8_t { Previous, Source, Product, Sum, Decal, Blend, Undefined };

/// A cell of the tables: the functions of colour and alpha. Both are Undefined where the specification says
/// so, and for COMBINE.
struct EnvCell {
    EnvFunction color;
    EnvFunction alpha;
};
[[nodiscard]] EnvCell environmentCell(EnvMode mode, BaseFormat format);

/// Tables 3.21 (REPLACE, MODULATE, DECAL) and 3.22 (BLEND, ADD). COMBINE has more state (see combine.h); here
/// it is undefined.
[[nodiscard]] EnvironmentResult evaluate(EnvMode mode, BaseFormat format, const EnvironmentInputs& inputs);

/// An equation for users: "Cv = Cp * Cs" and, for red, "0.5 * 0.4 = 0.2".
struct Equation {
    std::string symbols;
    std::vector<Sentence> numbers; ///< one for each component: 3 or 1
};

/// The equations of the colour and of alpha, with their numbers.
struct EnvironmentEquations {
    Equation color;
    Equation alpha;
    bool undefined = false;
};
[[nodiscard]] EnvironmentEquations equationsOf(EnvMode mode, BaseFormat format,
                                               const EnvironmentInputs& inputs);

} // namespace texplorer::reference
