#pragma once

// Anisotropic filtering as an elliptical weighted average (Paul Heckbert, "Fundamentals of Texture Mapping
// and Image Warping", 1989): what a round pixel sees of a plane is an ellipse of texels, with a Gaussian
// weight.

#include "core/reference/sample_record.h"
#include "core/reference/texel.h"
#include "core/reference/wrap.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer::reference {

/// The texels (u, v) around the ellipse's centre with A u^2 + B u v + C v^2 < F.
struct Ellipse {
    float a;
    float b;
    float c;
    float f;

    /// `x` and `y`: how far the sample moves per pixel, in texels. One texel is added to both axes, so that
    /// the ellipse always holds some.
    Ellipse(glm::vec2 x, glm::vec2 y)
        : a(x.y * x.y + y.y * y.y + 1)
        , b(-2 * (x.x * x.y + y.x * y.y))
        , c(x.x * x.x + y.x * y.x + 1)
        , f(a * c - b * b / 4) {}

    /// The halves of the box around it.
    [[nodiscard]] glm::vec2 halfExtent() const {
        const float d = 4 * a * c - b * b;
        return {2 * std::sqrt(c * f / d), 2 * std::sqrt(a * f / d)};
    }
    /// 0 at the centre, 1 on the rim.
    [[nodiscard]] float radius2(glm::vec2 at) const {
        return (a * at.x * at.x + b * at.x * at.y + c * at.y * at.y) / f;
    }
};

/// A texel's index after wrapping, from one that counts on beyond the level: the texel that NEAREST takes at
/// its centre.
[[nodiscard]] inline int wrappedTexel(Wrap wrap, int index, int size) {
    const float centre = (static_cast<float>(index) + 0.5F) / static_cast<float>(size);
    return nearestTexel(wrapCoordinate(wrap, centre, size), size);
}

/// The weighted mean of a level's texels in the pixel's footprint. A picture only.
template<class Recorder>
glm::vec4 averageOverEllipse(const SampledTexture& texture, int number, glm::vec3 coords,
                             const Derivatives& derivatives, const Recorder& recorder) {
    const Level* level = texture.level(number);
    if (!level)
        return {0, 0, 0, 1};
    const glm::vec2 size(level->size());
    const Ellipse ellipse(glm::vec2(derivatives.dx) * size, glm::vec2(derivatives.dy) * size);
    const glm::vec2 centre(definedCoordinate(coords.s) * size.x - 0.5F,
                           definedCoordinate(coords.t) * size.y - 0.5F);
    // Rounding can make an ellipse of an extreme footprint endless; no weight is left beyond this, either.
    const glm::vec2 half = ellipse.halfExtent();
    constexpr float most = 64;
    const auto extent = [&](int axis) { return half[axis] <= most ? half[axis] : most; };
    const int u0 = floorToInt(centre.x - extent(0));
    const int u1 = floorToInt(centre.x + extent(0)) + 1;
    const int v0 = floorToInt(centre.y - extent(1));
    const int v1 = floorToInt(centre.y + extent(1)) + 1;

    const auto visit = [&](auto&& take) {
        for (int v = v0; v <= v1; ++v) {
            for (int u = u0; u <= u1; ++u) {
                const float r2 =
                    ellipse.radius2({static_cast<float>(u) - centre.x, static_cast<float>(v) - centre.y});
                if (r2 < 1)
                    take(glm::ivec3(wrappedTexel(texture.wrap[0], u, level->width),
                                    wrappedTexel(texture.wrap[1], v, level->height), 0),
                         std::exp(-2 * r2));
            }
        }
    };
    float total = 0;
    visit([&](glm::ivec3 /*index*/, float weight) { total += weight; });
    glm::vec4 sum(0);
    const auto take = [&](glm::ivec3 index, float share) {
        const bool border = isBeyond(*level, index, 2);
        const glm::vec4 color = border ? texture.borderColor : texelAt(*level, index, 2);
        recorder.tap({number, index, share, color, border});
        sum += share * color;
    };
    if (total > 0)
        visit([&](glm::ivec3 index, float weight) { take(index, weight / total); });
    else // so far outside that floats no longer tell texels apart
        take({nearestTexel(wrapCoordinate(texture.wrap[0], coords.s, level->width), level->width),
              nearestTexel(wrapCoordinate(texture.wrap[1], coords.t, level->height), level->height), 0},
             1);
    return sum;
}

} // namespace texplorer::reference
