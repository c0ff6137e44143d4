#include "texplorer/reference/raster/triangle.h"

#include "texplorer/reference/raster/corner.h"
#include "texplorer/reference/shading/pass_state.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texplorer::reference {

namespace {

/// A pixel centre on an edge belongs to the triangle if that is a left edge, or a horizontal one at the
/// bottom: each centre on a shared edge to exactly one of two triangles. Which one the specification leaves
/// open; Mesa decides like this for framebuffer objects. Counter-clockwise, left edges run down and bottom
/// ones to the right.
EdgeFunction edgeOf(const Corner& from, const Corner& to) {
    const std::int64_t x = to.x - from.x;
    const std::int64_t y = to.y - from.y;
    const bool owns = y < 0 || (y == 0 && x > 0);
    return {y * from.x - x * from.y - (owns ? 0 : 1), -y * subPixels, x * subPixels,
            1 / std::abs(static_cast<double>(y * subPixels))};
}

/// The gradient of a value with these at the three corners.
class Gradient {
public:
    explicit Gradient(const std::array<Corner, 3>& corners)
        : ab_(corners[1].window - corners[0].window)
        , ac_(corners[2].window - corners[0].window) {
        const auto snapped = [&](int i) {
            const auto& corner = corners[static_cast<std::size_t>(i)];
            return glm::dvec2(static_cast<double>(corner.x), static_cast<double>(corner.y)) /
                   double{subPixels};
        };
        const glm::dvec2 ab = snapped(1) - snapped(0);
        const glm::dvec2 ac = snapped(2) - snapped(0);
        const double snappedArea = ab.x * ac.y - ab.y * ac.x;
        area_ = ab_.x * ac_.y - ab_.y * ac_.x;
        // A sliver that only the snapping opened has no gradient of its own.
        if (!(area_ * 2 > snappedArea)) {
            ab_ = ab;
            ac_ = ac;
            area_ = snappedArea;
        }
    }

    template<class T, class Wide>
    [[nodiscard]] Plane<T> operator()(Wide a, Wide b, Wide c) const {
        const Wide ab = b - a;
        const Wide ac = c - a;
        return {T(a), T((ab * ac_.y - ac * ab_.y) / area_), T((ac * ab_.x - ab * ac_.x) / area_)};
    }

private:
    glm::dvec2 ab_;
    glm::dvec2 ac_;
    double area_ = 0;
};

} // namespace

Corner cornerOf(const ShadedVertex& vertex, Viewport viewport, bool perspective) {
    const glm::dvec4 clip(vertex.clip);
    Corner corner{};
    corner.vertex = &vertex;
    // Section 2.11.1: normalised device coordinates, then window coordinates.
    corner.window = {(clip.x / clip.w + 1) / 2 * viewport.width - 0.5,
                     (clip.y / clip.w + 1) / 2 * viewport.height - 0.5};
    corner.depth = std::clamp((clip.z / clip.w + 1) / 2, 0.0, 1.0);
    corner.invW = perspective ? 1 / clip.w : 1;
    corner.x = std::llrint(corner.window.x * subPixels);
    corner.y = std::llrint(corner.window.y * subPixels);
    return corner;
}

std::optional<Triangle> setUp(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c,
                              const PassState& pass, Viewport viewport, bool perspective) {
    std::array<Corner, 3> corners{cornerOf(a, viewport, perspective), cornerOf(b, viewport, perspective),
                                  cornerOf(c, viewport, perspective)};
    const auto area = [&] {
        return (corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
               (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x);
    };
    if (area() == 0)
        return std::nullopt;
    Triangle triangle;
    triangle.pass = &pass;
    triangle.seenFromBehind = area() < 0;
    if (triangle.seenFromBehind)
        std::swap(corners[1], corners[2]);
    // What is interpolated starts from the lowest corner, whichever came first: the same triangle has the
    // same depths once more.
    std::ranges::rotate(corners, std::ranges::min_element(corners, {}, [](const Corner& corner) {
                            return std::pair(corner.y, corner.x);
                        }));
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    triangle.minX = std::max(0, pixelAtOrAfter(left));
    triangle.maxX = std::min(viewport.width - 1, pixelAtOrBefore(right));
    triangle.minY = std::max(0, pixelAtOrAfter(low));
    triangle.maxY = std::min(viewport.height - 1, pixelAtOrBefore(high));
    if (triangle.minX > triangle.maxX || triangle.minY > triangle.maxY)
        return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.edges[i] = edgeOf(corners[i], corners[(i + 1) % 3]);

    const auto& first = corners[0]; // no structured binding: clang 14's lambdas can't take one
    const auto& second = corners[1];
    const auto& third = corners[2];
    triangle.origin = glm::vec2(first.window);
    const Gradient gradient(corners);
    triangle.depth = gradient.operator()<float>(first.depth, second.depth, third.depth);
    triangle.invW = gradient.operator()<float>(first.invW, second.invW, third.invW);
    const auto overW = [&](auto member) {
        return gradient.operator()<glm::vec4>(glm::dvec4(member(*first.vertex)) * first.invW,
                                              glm::dvec4(member(*second.vertex)) * second.invW,
                                              glm::dvec4(member(*third.vertex)) * third.invW);
    };
    const bool back = pass.twoSided && triangle.seenFromBehind;
    const auto primary = [back](const ShadedVertex& v) { return back ? v.back.primary : v.primary; };
    triangle.primary = overW(primary);
    if (primary(a) == primary(b) && primary(a) == primary(c))
        triangle.evenPrimary = primary(a);
    if (pass.separateSpecular)
        triangle.secondary = overW(
            [back](const ShadedVertex& v) { return glm::vec4(back ? v.back.secondary : v.secondary, 0); });
    if (pass.fog) {
        const auto distance = [](const Corner& corner) {
            return double{corner.vertex->fogDistance} * corner.invW;
        };
        triangle.fogDistance = gradient.operator()<float>(distance(first), distance(second), distance(third));
    }
    for (std::size_t u = 0; u < static_cast<std::size_t>(pass.unitsUsed); ++u) {
        if (pass.units[u].texture)
            triangle.texCoords[u] = overW([u](const ShadedVertex& v) { return v.texCoords[u]; });
    }
    return triangle;
}

} // namespace texplorer::reference
