#pragma once

#include "app/ui/model/session.h"
#include "app/ui/widgets/pictures.h"

#include <glm/vec2.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {

// What the texture space shows: the image and what wrapping makes of its surroundings, the axes, the outlines
// of the faces. However large the mesh and however far away the plane: Dear ImGui counts the vertices of a
// panel with 16 bits, and what is drawn here stays below.

/// From texture coordinates to pixels and back. t grows upwards. The place in its middle lies between pixels:
/// the middle of a picture is the edge of texels, and a pixel whose centre were on it would show either of
/// them, as rounding has it.
struct Canvas {
    ImVec2 low, high;
    ImVec2 middle;
    Plane plane;
    float pixelsPerUnit;

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

/// A rectangle of the texture plane.
struct Bounds {
    glm::vec2 low{0};
    glm::vec2 high{1};
};

/// The image and every vertex.
[[nodiscard]] Bounds boundsOf(const TexCoords& coords);

/// The image, tiled as its wrap modes say, around `used`. `id` is the GL texture that shows it.
void drawTiles(ImDrawList& draw, const Canvas& canvas, const Texture& texture, const Surface& image,
               view::PictureHandle picture, const Bounds& used);

/// The picture of a cube map with its faces side by side, as wide as the image is in drawTiles.
void drawUnfolded(ImDrawList& draw, const Canvas& canvas, const TextureImage& image,
                  view::PictureHandle picture);

/// s in red along the bottom edge of the image, t in green along its left edge, both with an arrow beyond 1.
void drawAxes(ImDrawList& draw, const Canvas& canvas);

/// Outlines and vertices, the chosen one and its faces in their colour. Of a mesh with very many faces only
/// those.
void drawMesh(ImDrawList& draw, const Canvas& canvas, const Mesh& mesh, const TexCoords& coords,
              std::optional<std::size_t> chosen, std::optional<std::size_t> hovered);

[[nodiscard]] bool contains(const Face& face, std::size_t vertex);

} // namespace texplorer::ui
