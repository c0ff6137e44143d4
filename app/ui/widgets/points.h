#pragma once

#include <imgui.h>

#include <cmath>

namespace texplorer::ui {

// Arithmetic of positions and sizes in the window.

[[nodiscard]] inline ImVec2 operator+(ImVec2 a, ImVec2 b) {
    return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline ImVec2 operator-(ImVec2 a, ImVec2 b) {
    return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline ImVec2 operator*(ImVec2 a, float factor) {
    return {a.x * factor, a.y * factor};
}

/// The nearest corner of pixels.
[[nodiscard]] inline ImVec2 rounded(ImVec2 at) {
    return {std::round(at.x), std::round(at.y)};
}

} // namespace texplorer::ui
