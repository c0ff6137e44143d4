#pragma once

#include <fmt/core.h>

#include <concepts>
#include <string>
#include <string_view>

namespace texplorer {

/// "0 bytes", "1 byte", "2 bytes": a number and its noun, with an s unless the number is 1.
[[nodiscard]] std::string countOf(std::integral auto count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

} // namespace texplorer
