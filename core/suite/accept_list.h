#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer::suite {

inline constexpr std::size_t maxAcceptBytes = std::size_t{64} << 20;

/// What the report's accept buttons write: a case's name on a line; "#" begins a comment, and empty lines
/// don't count. Each name once, in the order of the list. Errors with the line in `where`: names that aren't
/// among the known ones, with the nearest of these; none at all; TooLarge.
[[nodiscard]] Result<std::vector<std::string>> parseAcceptList(std::string_view text,
                                                               const std::vector<std::string>& known);

} // namespace texplorer::suite
