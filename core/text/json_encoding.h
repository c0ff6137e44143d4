#pragma once

#include "texplorer/base/result.h"

#include <string_view>

namespace texplorer {

inline constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF"; ///< of UTF-8

/// Refuses what isn't UTF-8 because another encoding was meant, and NUL, which JSON doesn't contain (RFC
/// 8259, 2): nlohmann-json takes it for the end of the text and ignores the rest.
[[nodiscard]] Result<void> checkEncoding(std::string_view json);

/// The line and the column of a byte.
[[nodiscard]] Location atCharacter(std::string_view text, std::size_t byte);

/// A key as a JSON pointer has it (RFC 6901).
[[nodiscard]] std::string pointerStep(std::string_view key);

} // namespace texplorer
