#pragma once

#include "texplorer/reference/explain/explanation_steps.h"

#include <array>

namespace texplorer::reference {

// Where the texture coordinates of a fragment come from, and rows of coordinates for other steps.

inline constexpr std::array<const char*, 4> coordinateNames{"s", "t", "r", "q"};
inline constexpr std::array<Ink, 4> coordinateInks{Ink::S, Ink::T, Ink::R, Ink::Q};

/// The names of the first coordinates, above rows of their values.
[[nodiscard]] StepRow heading(const char* label, int count);
[[nodiscard]] StepRow coordinates(Sentence label, glm::vec4 values, int count = 4, int digits = 4);

/// Whether r is compared with what the texture holds.
[[nodiscard]] bool compares(const UnitExplanation& unit);

[[nodiscard]] Step coordinatesStep(const FragmentExplanation& fragment, const UnitExplanation& unit);

} // namespace texplorer::reference
