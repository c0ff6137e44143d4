#pragma once

#include <fmt/core.h>

#include <string>

namespace texplorer::view {

/// The size of a picture or a window.
struct Size {
    int width = 0;
    int height = 0;
    bool operator==(const Size&) const = default;
};

/// "640 x 480"
[[nodiscard]] inline std::string asText(Size size) {
    return fmt::format("{} × {}", size.width, size.height);
}

} // namespace texplorer::view
