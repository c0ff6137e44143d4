#pragma once

#include <imgui.h>

#include <span>
#include <vector>

namespace texplorer::ui {

/// A rectangle in the window; y points down.
struct Box {
    ImVec2 low;
    ImVec2 high;
};

[[nodiscard]] inline bool overlaps(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// The common area in pixels; 0: they do not overlap.
[[nodiscard]] float sharedArea(const Box& a, const Box& b);

/// An area that insets should not cover.
struct Uncovered {
    Box box;
    float worth; ///< of each of its pixels
};

/// The upper left corners of small pictures of these sizes along the edges of a room, where they cover the
/// least worth: next to each other or one above the other, at either end of an edge or at both. The lower
/// edge is preferred. Pure.
[[nodiscard]] std::vector<ImVec2> placeInsets(std::span<const ImVec2> sizes, const Box& room, float gap,
                                              std::span<const Uncovered> kept);

} // namespace texplorer::ui
