#pragma once

#include "texplorer/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace texplorer::suite {

inline constexpr std::size_t maxAcceptBytes = std::size_t{64} << 20;

/// Parses the list of the report's accept buttons: a case's name per line; "#" begins a comment, empty lines
/// are ignored. Returns each name once, in the order of the list. Errors with the line in `where`: unknown
/// names, with the nearest known ones; an empty list; TooLarge.
[[nodiscard]] Result<std::vector<std::string>> parseAcceptList(std::string_view text,
                                                               const std::vector<std::string>& known);

} // namespace texplorer::suite
