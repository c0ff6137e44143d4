#pragma once

#include "app/ui/texture_space/plane_coords.h"
#include "app/ui/widgets/inset_placement.h"
#include "app/ui/widgets/pictures.h"

#include <glm/vec2.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace texplorer::ui {

// Draws the texture space below the outlines: the image, its surroundings by the wrap modes, and the axes.
// Dear ImGui counts the vertices of a panel with 16 bits; these functions stay below that at any zoom.

/// Converts texture coordinates to pixels and back. t increases upwards. The middle of the plane is between
/// pixels: the middle of a picture is an edge of texels, and a pixel centre on it would show either of them,
/// depending on rounding.
struct Canvas {
    ImVec2 low, high;
    ImVec2 middle;
    Plane plane;
    float pixelsPerUnit;
    Box legend{};                 ///< names the shown things: small pictures do not cover it
    std::vector<ImVec2> chosen{}; ///< vertices that they do not cover either

    Canvas(ImVec2 topLeft, ImVec2 size, const Plane& seen)
        : low(topLeft)
        , high(topLeft.x + size.x, topLeft.y + size.y)
        , middle(std::floor((low.x + high.x) / 2), std::floor((low.y + high.y) / 2))
        , plane(seen)
        , pixelsPerUnit(std::min(size.x, size.y) / seen.extent) {}

    /// Positions far away are clamped: a scene's coordinates go up to the largest float, and Dear ImGui draws
    /// wrong lines for infinite positions.
    [[nodiscard]] ImVec2 toPixel(float s, float t) const {
        static constexpr float farthest = 1e7F;
        const auto within = [](float pixel) { return std::clamp(pixel, -farthest, farthest); };
        return {within(middle.x + (s - plane.s) * pixelsPerUnit),
                within(middle.y - (t - plane.t) * pixelsPerUnit)};
    }
    [[nodiscard]] ImVec2 toPixel(glm::vec2 place) const { return toPixel(place.x, place.y); }
    [[nodiscard]] bool holds(ImVec2 at) const {
        return at.x >= low.x && at.x <= high.x && at.y >= low.y && at.y <= high.y;
    }
    [[nodiscard]] glm::vec2 toCoord(ImVec2 pixel) const {
        return {plane.s + (pixel.x - middle.x) / pixelsPerUnit,
                plane.t - (pixel.y - middle.y) / pixelsPerUnit};
    }
};

/// A colour with its alpha multiplied.
[[nodiscard]] ImU32 faded(ImU32 tint, float share);

/// The box of a text with a dark background, which is readable on any picture.
[[nodiscard]] Box chipBox(ImVec2 at, ImVec2 size);
void drawTextChip(ImDrawList& draw, const Box& box, float size, ImU32 tint, const std::string& text);

/// Contains the image and every vertex, by its given and its final coordinates.
[[nodiscard]] Bounds boundsOf(const PlaneCoords& coords);

/// The picture of the image.
struct TilePicture {
    view::PictureHandle handle = view::PictureHandle::None;
    int width = 1; ///< texels
    int height = 1;
    bool board = false;                   ///< transparent parts show a checkerboard
    bool opaque = false;                  ///< has no transparent parts
    bool ignoresAlpha = false;            ///< transparent parts are drawn opaque
    ImDrawCallback setBlending = nullptr; ///< see Pictures; nullptr: blending is not changed
};

/// Draws the image, tiled by its wrap modes, around `used`; and the ground beyond it.
void drawTiles(ImDrawList& draw, const Canvas& canvas, const Texture& texture, const TilePicture& picture,
               const Bounds& used);

/// Draws the picture of a cube map with its faces side by side, as wide as the image in drawTiles; `tall`
/// times as high.
void drawUnfolded(ImDrawList& draw, const Canvas& canvas, view::PictureHandle picture, float tall);

/// s in red along the bottom edge of the image, t in green along its left edge, both with an arrow beyond 1.
void drawAxes(ImDrawList& draw, const Canvas& canvas);

} // namespace texplorer::ui
