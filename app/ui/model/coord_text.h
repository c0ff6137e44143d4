#pragma once

#include "texplorer/base/result.h"
#include "texplorer/scene/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Coordinates as lines of text, "0.25 0.5"; with r and q unless they are 0 and 1.
[[nodiscard]] std::string coordText(std::span<const glm::vec4> coords);

/// Parses such lines: two to four numbers each, separated by blanks, commas, semicolons or parentheses.
/// Missing r is 0 and missing q 1. Empty lines are ignored. The error names the line with something that is
/// not a number, with too few or too many numbers, or with a number that is too large; or says that there are
/// no lines.
[[nodiscard]] Result<TexCoords> parseCoordText(std::string_view text);

} // namespace texplorer::ui
