#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace texplorer::ui {

/// Coordinates as lines of text, "0.25 0.5"; with r and q where these aren't 0 and 1.
[[nodiscard]] std::string coordText(std::span<const glm::vec4> coords);

/// What such lines say: two to four numbers each, with blanks, commas, semicolons or parentheses around them.
/// r is 0 and q 1 where they aren't given. Empty lines don't count. The error names the line: what isn't a
/// number, numbers that are too few or too many, or too large; or says that there are no lines.
[[nodiscard]] Result<TexCoords> parseCoordText(std::string_view text);

} // namespace texplorer::ui
