#pragma once

// The pieces that messages about parameters are made of. Input from outside is quoted, cut and made
// printable.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer {

/// The shortest digits that read back as the same float: "0.1", "1000", "1e-05". Independent of the locale.
[[nodiscard]] std::string formatNumber(float number);

/// Such numbers, one after the other.
[[nodiscard]] std::string formatNumbers(std::span<const float> numbers, std::string_view separator = ",");

/// The text in double quotes, at most about 40 bytes of it, printable
/// (core/base/printable.h).
[[nodiscard]] std::string inQuotes(std::string_view text);

/// The same without the quotes, for a name inside a path.
[[nodiscard]] std::string shortened(std::string_view text);

/// The name closest to a misspelt one, or an empty view where none is close. Ignores case.
[[nodiscard]] std::string_view nearestName(std::string_view text, const std::vector<std::string_view>& names);

/// `did you mean "minFilter"?`, or else `expected one of a, b, c`.
[[nodiscard]] std::string suggestName(std::string_view text, const std::vector<std::string_view>& names);

} // namespace texplorer
