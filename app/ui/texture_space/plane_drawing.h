#pragma once

#include "app/ui/model/session.h"
#include "app/ui/texture_space/plane_coords.h"
#include "app/ui/widgets/inset_placement.h"
#include "app/ui/widgets/pictures.h"

#include <glm/vec2.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace texplorer::ui {

// What the texture space shows below the outlines: the image, what wrapping makes of its surroundings, and
// the axes. However far away the plane: Dear ImGui counts the vertices of a panel with 16 bits, and what is
// drawn here stays below.

/// From texture coordinates to pixels and back. t grows upwards. The place in its middle lies between pixels:
/// the middle of a picture is the edge of texels, and a pixel whose centre were on it would show either of
/// them, as rounding has it.
struct Canvas {
    ImVec2 low, high;
    ImVec2 middle;
    Plane plane;
    float pixelsPerUnit;
    Box legend{};                 ///< what names the things that are shown: small pictures leave it free
    std::vector<ImVec2> chosen{}; ///< vertices, which they leave free, too

    Canvas(ImVec2 topLeft, ImVec2 size, const Plane& seen)
        : low(topLeft)
        , high(topLeft.x + size.x, topLeft.y + size.y)
        , middle(std::floor((low.x + high.x) / 2), std::floor((low.y + high.y) / 2))
        , plane(seen)
        , pixelsPerUnit(std::min(size.x, size.y) / seen.extent) {}

    /// What lies very far away is drawn at its border: a scene's coordinates go up to the largest float, and
    /// Dear ImGui makes lines of no place from what is infinite.
    [[nodiscard]] ImVec2 toPixel(float s, float t) const {
        static constexpr float farthest = 1e7F;
        const auto within = [](float pixel) { return std::clamp(pixel, -farthest, farthest); };
        return {within(middle.x + (s - plane.s) * pixelsPerUnit),
                within(middle.y - (t - plane.t) * pixelsPerUnit)};
    }
    [[nodiscard]] glm::vec2 toCoord(ImVec2 pixel) const {
        return {plane.s + (pixel.x - middle.x) / pixelsPerUnit,
                plane.t - (pixel.y - middle.y) / pixelsPerUnit};
    }
};

/// A colour with a share of its alpha.
[[nodiscard]] ImU32 faded(ImU32 tint, float share);

/// A rectangle of the texture plane.
struct Bounds {
    glm::vec2 low{0};
    glm::vec2 high{1};
};

/// The image and every vertex, as it is given and where it ends.
[[nodiscard]] Bounds boundsOf(const PlaneCoords& coords);

/// The picture of the image.
struct TilePicture {
    view::PictureHandle handle = view::PictureHandle::None;
    int width = 1; ///< texels
    int height = 1;
    bool board = false;                   ///< what is transparent shows a checkerboard
    bool opaque = false;                  ///< nothing is transparent
    bool ignoresAlpha = false;            ///< what is transparent is shown as if it weren't
    ImDrawCallback setBlending = nullptr; ///< see Pictures; nullptr: blending stays
};

/// Whether an image has texels that may be transparent.
[[nodiscard]] bool hasAlpha(const Surface& surface);

/// The image, tiled as its wrap modes say, around `used`; and beyond it the ground.
void drawTiles(ImDrawList& draw, const Canvas& canvas, const Texture& texture, const TilePicture& picture,
               const Bounds& used);

/// The picture of a cube map with its faces side by side, as wide as the image is in drawTiles; `tall` times
/// as high.
void drawUnfolded(ImDrawList& draw, const Canvas& canvas, view::PictureHandle picture, float tall);

/// Of the picture that the host has of a cube map's base level.
[[nodiscard]] float unfoldedHeight(const TextureImage& image);

/// s in red along the bottom edge of the image, t in green along its left edge, both with an arrow beyond 1.
void drawAxes(ImDrawList& draw, const Canvas& canvas);

} // namespace texplorer::ui
