#pragma once

#include <string_view>
#include <vector>

namespace texplorer {

/// Suggests names for a misspelt text, in the order of `names`: the names that begin with the text, if it has
/// three letters or more; else all names at the smallest edit distance (missing, extra, wrong or swapped
/// letters), if that is at most a third of the text's length, or 1. Ignores the case of ASCII letters.
[[nodiscard]] std::vector<std::string_view> nearestNames(std::string_view text,
                                                         const std::vector<std::string_view>& names);

/// Returns the first suggestion, or an empty view.
[[nodiscard]] std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

} // namespace texplorer
