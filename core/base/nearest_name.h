#pragma once

#include <string_view>
#include <vector>

namespace texplorer {

/// The names that somebody may have meant, in their order: those that begin with the text, where it has three
/// letters or more; else those closest to it, by how many letters are missing, too many, wrong or swapped,
/// all that are equally close; none where none is close, which is a third of its letters. Ignores the case of
/// ASCII's letters.
[[nodiscard]] std::vector<std::string_view> nearestNames(std::string_view text,
                                                         const std::vector<std::string_view>& names);

/// The first of them, or an empty view.
[[nodiscard]] std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

} // namespace texplorer
