#pragma once

#include "core/suite/plan.h"

namespace texplorer::suite {

inline constexpr std::size_t maxAcceptBytes = std::size_t{64} << 20;

/// What the report's accept buttons write: a case's name on a line; "#" begins a comment, and empty lines
/// don't count. Each name once, in the order of the list. Errors with the line in `where`: names that the
/// plan hasn't, with the nearest one that it has; TooLarge.
[[nodiscard]] Result<std::vector<std::string>> parseAcceptList(std::string_view text, const Plan& plan);

/// The same for any names.
[[nodiscard]] Result<std::vector<std::string>> parseAcceptList(std::string_view text,
                                                               const std::vector<std::string>& known);

} // namespace texplorer::suite
