#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace texplorer::ui {

/// A rectangle of the window, y downwards.
struct Box {
    ImVec2 low;
    ImVec2 high;
};

[[nodiscard]] inline bool overlaps(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// In pixels; 0: they don't overlap.
[[nodiscard]] float sharedArea(const Box& a, const Box& b);

/// What one would rather see than an inset.
struct Uncovered {
    Box box;
    float worth; ///< of each pixel of it
};

/// The upper left corners of small pictures of these sizes along the edges of a room, where they cover what
/// is worth least: beside each other or one above the other, at either end of an edge or at both. The lower
/// edge is taken where it is as good as another. Pure.
[[nodiscard]] std::vector<ImVec2> placeInsets(std::span<const ImVec2> sizes, const Box& room, float gap,
                                              std::span<const Uncovered> kept);

} // namespace texplorer::ui
