#pragma once

// Anisotropic filtering as an elliptical weighted average (Paul Heckbert, "Fundamentals of Texture Mapping
// and Image Warping", 1989): a round pixel projects to an ellipse of texels, weighted by a Gaussian.

#include "texplorer/reference/sampling/depth_texel.h"
#include "texplorer/reference/sampling/sample_record.h"
#include "texplorer/reference/sampling/texel.h"
#include "texplorer/reference/sampling/wrap.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::reference {

/// The texels (u, v) around the ellipse's centre with A u^2 + B u v + C v^2 < F, where
///     A = (dv/dx)^2 + (dv/dy)^2 + 1, B = -2 (du/dx dv/dx + du/dy dv/dy), C = (du/dx)^2 + (du/dy)^2 + 1 and
///     F = A C - B^2 / 4:
/// one texel is added to both axes, so that the ellipse always contains a texel. Both sides are computed as
/// sums of squares, which stay positive under rounding for any shape; doubles can represent them.
class Ellipse {
public:
    /// `x` and `y`: the change of the position per pixel, in texels.
    Ellipse(glm::dvec2 x, glm::dvec2 y)
        : x_(x)
        , y_(y) {
        const double area = x.x * y.y - x.y * y.x;
        f_ = area * area + glm::dot(x, x) + glm::dot(y, y) + 1;
    }

    /// Half the size of its bounding box: the roots of C and A.
    [[nodiscard]] glm::dvec2 halfExtent() const {
        return {std::sqrt(x_.x * x_.x + y_.x * y_.x + 1), std::sqrt(x_.y * x_.y + y_.y * y_.y + 1)};
    }
    /// 0 at the centre, 1 at the edge.
    [[nodiscard]] double radius2(glm::dvec2 at) const {
        const double acrossX = x_.y * at.x - x_.x * at.y;
        const double acrossY = y_.y * at.x - y_.x * at.y;
        return (acrossX * acrossX + acrossY * acrossY + at.x * at.x + at.y * at.y) / f_;
    }

private:
    glm::dvec2 x_;
    glm::dvec2 y_;
    double f_;
};

/// Wraps a texel's index: the texel that NEAREST reads at its centre.
[[nodiscard]] inline int wrappedTexel(Wrap wrap, int index, int size) {
    const float centre = (static_cast<float>(index) + 0.5F) / static_cast<float>(size);
    return nearestTexel(wrapCoordinate(wrap, centre, size), size);
}

/// The weighted mean of a level's texels in the pixel's footprint. Pictures only.
template<class Recorder>
glm::vec4 averageOverEllipse(const SampledTexture& texture, int number, glm::vec3 coords,
                             const Derivatives& derivatives, const Recorder& recorder) {
    const Level* level = texture.level(number);
    if (!level)
        return {0, 0, 0, 1};
    const glm::vec2 size(level->size());
    const Ellipse ellipse(glm::dvec2(derivatives.dx) * glm::dvec2(size),
                          glm::dvec2(derivatives.dy) * glm::dvec2(size));
    const glm::vec2 centre(definedCoordinate(coords.s) * size.x - 0.5F,
                           definedCoordinate(coords.t) * size.y - 0.5F);
    // An extreme footprint covers a huge number of texels; the mean of this extent is accurate enough.
    constexpr double maxExtent = 64;
    const glm::vec2 extent(glm::min(ellipse.halfExtent(), maxExtent));
    const int u0 = floorToInt(centre.x - extent.x);
    const int u1 = floorToInt(centre.x + extent.x) + 1;
    const int v0 = floorToInt(centre.y - extent.y);
    const int v1 = floorToInt(centre.y + extent.y) + 1;

    const auto visit = [&](auto&& take) {
        for (int v = v0; v <= v1; ++v) {
            for (int u = u0; u <= u1; ++u) {
                const auto r2 = static_cast<float>(
                    ellipse.radius2({static_cast<float>(u) - centre.x, static_cast<float>(v) - centre.y}));
                if (r2 < 1)
                    take(glm::ivec3(wrappedTexel(texture.wrapS, u, level->width),
                                    wrappedTexel(texture.wrapT, v, level->height), 0),
                         std::exp(-2 * r2));
            }
        }
    };
    float total = 0;
    visit([&](glm::ivec3 /*index*/, float weight) { total += weight; });
    glm::vec4 sum(0);
    const auto take = [&](glm::ivec3 index, float share) {
        const bool border = isBeyond(*level, index, 2);
        const glm::vec4 stored = border ? texture.borderColor : texelAt(*level, index, 2);
        const glm::vec4 color =
            isDepth(texture.internalFormat) ? depthColor(texture, stored.r, coords.p) : stored;
        recorder.tap({number, index, share, color, border, stored.r});
        sum += share * color;
    };
    if (total > 0)
        visit([&](glm::ivec3 index, float weight) { take(index, weight / total); });
    else // so far outside that floats cannot distinguish texels
        take({nearestTexel(wrapCoordinate(texture.wrapS, coords.s, level->width), level->width),
              nearestTexel(wrapCoordinate(texture.wrapT, coords.t, level->height), level->height), 0},
             1);
    return sum;
}

} // namespace texplorer::reference
