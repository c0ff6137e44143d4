#pragma once

// Texture wrap modes: OpenGL 2.1, section 3.8.7, and the selection of texels in 3.8.8.
//
// The specification clamps a coordinate s and then multiplies it by the number of texels N. Here, u = s N is
// clamped to the limits times N: mathematically the same, but 1/2 is exact and 1/(2 N) is not.

#include "texplorer/gl/sampling.h"

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

/// NaN and infinite coordinates become 0.
[[nodiscard]] inline float definedCoordinate(float coordinate) {
    return std::isfinite(coordinate) ? coordinate : 0.0F;
}

/// Rounds down to an int; values out of range become the nearest allowed one, NaN becomes 0.
[[nodiscard]] inline int floorToInt(float value) {
    constexpr float limit = 0x1p30F;
    return static_cast<int>(std::floor(value >= -limit ? std::min(value, limit) : value < 0 ? -limit : 0.0F));
}

/// The distance of s from the nearest even integer, in [0, 1]: 0.25 stays, 1.25 becomes 0.75, -0.25 becomes
/// 0.25.
[[nodiscard]] inline float mirror(float s) {
    const float whole = std::floor(s);
    const float fraction = s - whole;
    return std::fmod(whole, 2.0F) == 0.0F ? fraction : 1 - fraction;
}

/// u: the position of the coordinate in a row of `size` texels; texel i reaches from i to i + 1.
[[nodiscard]] inline float wrapCoordinate(Wrap wrap, float coordinate, int size) {
    const float s = definedCoordinate(coordinate);
    const auto n = static_cast<float>(size);
    switch (wrap) {
    case Wrap::Repeat:
        return (s - std::floor(s)) * n;
    case Wrap::MirroredRepeat:
        return std::clamp(mirror(s) * n, 0.5F, n - 0.5F);
    case Wrap::ClampToEdge:
        return std::clamp(s * n, 0.5F, n - 0.5F);
    case Wrap::ClampToBorder:
        return std::clamp(s * n, -0.5F, n + 0.5F);
    case Wrap::Clamp:
        return std::clamp(s * n, 0.0F, n);
    }
    return 0;
}

/// Under NEAREST: the texel that contains u. u = N, the end, belongs to the last one.
[[nodiscard]] inline int nearestTexel(float u, int size) {
    return u == static_cast<float>(size) ? size - 1 : floorToInt(u);
}

/// Under LINEAR: the texels on both sides of u, and its position between their centres. Indices outside of
/// [0, size) are border, except for GL_REPEAT, where the ends are adjacent.
struct TexelPair {
    int first;
    int second;
    float share; ///< of `second`
};
[[nodiscard]] inline TexelPair linearTexels(Wrap wrap, float u, int size) {
    const float low = std::floor(u - 0.5F);
    const int first = floorToInt(low);
    const TexelPair pair{first, first + 1, u - 0.5F - low};
    if (wrap != Wrap::Repeat)
        return pair;
    return {first < 0 ? first + size : first, pair.second >= size ? pair.second - size : pair.second,
            pair.share};
}

} // namespace texplorer::reference
