#pragma once

// The colour spaces of FLIP. Light is linear, 0 to 1, with sRGB's primaries.

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer {

using FlipColor = std::array<float, 3>;

[[nodiscard]] constexpr float ratioOf(double above, double below) {
    return static_cast<float>(above / below);
}

/// sRGB's primaries (IEC 61966-2-1) to XYZ and back, and their white point, D65.
inline constexpr std::array lightToXyz{
    FlipColor{ratioOf(10135552, 24577794), ratioOf(8788810, 24577794), ratioOf(4435075, 24577794)},
    FlipColor{ratioOf(2613072, 12288897), ratioOf(8788810, 12288897), ratioOf(887015, 12288897)},
    FlipColor{ratioOf(1425312, 73733382), ratioOf(8788810, 73733382), ratioOf(70074185, 73733382)}};
inline constexpr std::array xyzToLight{FlipColor{3.241003275F, -1.537398934F, -0.498615861F},
                                       FlipColor{-0.969224334F, 1.875930071F, 0.041554224F},
                                       FlipColor{0.055639423F, -0.204011202F, 1.057148933F}};
inline constexpr FlipColor white{0.950428545F, 1, 1.088900371F};

[[nodiscard]] inline FlipColor multiply(const std::array<FlipColor, 3>& matrix, const FlipColor& color) {
    FlipColor result{};
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = matrix[i][0] * color[0] + matrix[i][1] * color[1] + matrix[i][2] * color[2];
    return result;
}

/// Y, Cx, Cz: an opponent space that is linear in light.
[[nodiscard]] inline FlipColor opponentOf(const FlipColor& light) {
    const FlipColor xyz = multiply(lightToXyz, light);
    const float x = xyz[0] / white[0];
    const float z = xyz[2] / white[2];
    return {116 * xyz[1] - 16, 500 * (x - xyz[1]), 200 * (xyz[1] - z)};
}

/// Clamped to the range of a screen.
[[nodiscard]] inline FlipColor lightOfOpponent(const FlipColor& opponent) {
    const float y = (opponent[0] + 16) / 116;
    const FlipColor xyz{(opponent[1] / 500 + y) * white[0], y, (y - opponent[2] / 200) * white[2]};
    FlipColor light = multiply(xyzToLight, xyz);
    for (float& each : light)
        each = std::clamp(each, 0.0F, 1.0F);
    return light;
}

/// CIE L*a*b*, with less saturation for dark pixels (the Hunt effect): section 4.1.
[[nodiscard]] inline FlipColor huntLabOf(const FlipColor& light) {
    constexpr float delta = 6.0F / 29;
    FlipColor f = multiply(lightToXyz, light);
    for (std::size_t i = 0; i < f.size(); ++i) {
        const float t = f[i] / white[i];
        f[i] = t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0F / 29;
    }
    const float lightness = 116 * f[1] - 16;
    return {lightness, 0.01F * lightness * (500 * (f[0] - f[1])), 0.01F * lightness * (200 * (f[1] - f[2]))};
}

/// A metric for large colour differences: Abasi, Amani Tehran, Fairchild 2019.
[[nodiscard]] inline float hyab(const FlipColor& a, const FlipColor& b) {
    const float da = a[1] - b[1];
    const float db = a[2] - b[2];
    return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

} // namespace texplorer
