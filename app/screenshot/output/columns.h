#pragma once

#include <cstddef>
#include <string_view>

namespace texplorer::screenshot {

/// How many columns of a terminal a text in UTF-8 takes: continuation bytes take none.
[[nodiscard]] std::size_t columnsOf(std::string_view text);

} // namespace texplorer::screenshot
