#pragma once

#include <glm/vec3.hpp>
#include <imgui.h>

#include <span>
#include <string>

namespace texplorer::ui {

/// The rectangle of a plot in the window: x to the right, y upwards.
struct PlotBox {
    ImVec2 low;  ///< upper left
    ImVec2 high; ///< lower right
    float xFrom = 0;
    float xTo = 1;
    float yFrom = 0;
    float yTo = 1;

    [[nodiscard]] float width() const { return high.x - low.x; }
    [[nodiscard]] float height() const { return high.y - low.y; }
    [[nodiscard]] float middle() const { return (low.y + high.y) / 2; }
    [[nodiscard]] float atX(float x) const { return low.x + (x - xFrom) / (xTo - xFrom) * width(); }
    [[nodiscard]] float atY(float y) const { return high.y - (y - yFrom) / (yTo - yFrom) * height(); }
    [[nodiscard]] ImVec2 at(float x, float y) const { return {atX(x), atY(y)}; }
    /// The x value at a position in the window.
    [[nodiscard]] float xOf(float place) const { return xFrom + (place - low.x) / width() * (xTo - xFrom); }
};

/// A colour of the scene, opaque.
[[nodiscard]] ImU32 plotColor(glm::vec3 color);

/// A text colour that is readable on a colour of the scene, in every theme.
[[nodiscard]] ImU32 inkOn(glm::vec3 color);

/// A small, already translated text. `anchor`: the fraction of its size to the left of `at` and above it.
void plotText(ImVec2 at, ImVec2 anchor, const std::string& text, ImU32 ink);

/// The size of such a text.
[[nodiscard]] ImVec2 plotTextSize(const std::string& text);

/// The width of names in English to the left of plots, and the names themselves, each in the middle of its
/// plot's height.
[[nodiscard]] float plotNamesWidth(std::span<const char* const> names);
void plotNames(float left, std::span<const char* const> names, std::span<const PlotBox> boxes);

/// Draws a dim word in English before the control of a line, which is at `x`; 0: `gap` behind the word, -1:
/// the usual one.
void rowName(const char* words, float x = 0, float gap = -1);

/// A line of already translated text: drawn with smaller letters if it does not fit, and cut if those do not
/// fit either.
void shrunkText(ImVec2 at, const std::string& words, float size, float room, ImU32 ink);

/// Draws parallel lines from lower left to upper right within a convex polygon, `gap` pixels apart; lines of
/// adjacent shapes are aligned.
void hatch(std::span<const ImVec2> polygon, float gap, ImU32 tint, float width);

/// The line width of all figures.
[[nodiscard]] float plotLine();

} // namespace texplorer::ui
