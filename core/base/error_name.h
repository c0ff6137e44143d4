#pragma once

#include "texplorer/base/result.h"

#include <array>
#include <string_view>

namespace texplorer {

/// "NotFound": for programs.
[[nodiscard]] constexpr std::string_view nameOf(ErrorCode code) {
    constexpr std::array<std::string_view, 9> names{"NotFound",  "Unreadable",  "Unwritable",
                                                    "Malformed", "Unsupported", "OutOfRange",
                                                    "TooLarge",  "Driver",      "Cancelled"};
    return names[static_cast<std::size_t>(code)];
}

} // namespace texplorer
