#pragma once

// Images of floats: red, green, blue and alpha of any size, as textures of GL_ARB_texture_float store them.

#include "texplorer/image/image.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace texplorer {

using FloatTexel = std::array<float, 4>;

[[nodiscard]] inline FloatTexel floatsAt(const std::byte* pixel) {
    FloatTexel texel;
    std::memcpy(texel.data(), pixel, sizeof texel);
    return texel;
}

inline void storeFloats(const FloatTexel& texel, std::byte* pixel) {
    std::memcpy(pixel, texel.data(), sizeof texel);
}

/// Limited to 0 … 1, in 255ths. NaN becomes 0.
[[nodiscard]] std::array<std::uint8_t, 4> bytesOfFloats(const FloatTexel& texel);

/// The nearest number that a float of 16 bits has: 11 significant bits, steps of 2^-24 below 2^-14, and no
/// finite number beyond 65504. A tie goes to the even one. Infinities and NaN are returned as they are.
[[nodiscard]] float roundedToHalf(float value);

/// Returns the image's pixels as a texture with `bits` bits per component, 16 or 32, stores them: RgbaFloat.
[[nodiscard]] Image floatsOf(const Image& image, int bits);

} // namespace texplorer
