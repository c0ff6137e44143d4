#pragma once

#include "texplorer/base/result.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace texplorer {

/// Refuses NUL: nlohmann-json takes it for the end of the text and ignores the rest. JSON contains none (RFC
/// 8259, 2).
[[nodiscard]] inline Result<void> checkNoNul(std::string_view json) {
    const std::size_t at = json.find('\0');
    if (at == std::string_view::npos)
        return {};
    const auto line = 1 + std::ranges::count(json.substr(0, at), '\n');
    return fail(ErrorCode::Malformed, "expected JSON, found a NUL character", "line " + std::to_string(line));
}

} // namespace texplorer
