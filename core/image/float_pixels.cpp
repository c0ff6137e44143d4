#include "texplorer/image/float_pixels.h"

#include "texplorer/image/convert.h"

#include <algorithm>
#include <cmath>

namespace texplorer {

std::array<std::uint8_t, 4> bytesOfFloats(const FloatTexel& texel) {
    std::array<std::uint8_t, 4> bytes{};
    for (std::size_t i = 0; i < texel.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(
            texel[i] > 0 ? std::lround(std::min(texel[i], 1.0F) * 255) : 0); // also of NaN
    return bytes;
}

float roundedToHalf(float value) {
    constexpr float largest = 65504;
    constexpr int significantBits = 11;
    constexpr int leastExponent = -13; // that frexp gives of 2^-14
    if (!std::isfinite(value))
        return value;
    int exponent = 0;
    static_cast<void>(std::frexp(value, &exponent));
    const int lastBit = std::max(exponent, leastExponent) - significantBits;
    const float rounded = std::ldexp(std::nearbyint(std::ldexp(value, -lastBit)), lastBit);
    return std::clamp(rounded, -largest, largest);
}

Image floatsOf(const Image& image, int bits) {
    Image floats = Image::uninitialised(PixelFormat::RgbaFloat, image.width, image.height, image.depth);
    const bool areFloats = image.format == PixelFormat::RgbaFloat;
    const std::byte* from = image.pixels.data();
    for (std::size_t at = 0; at < floats.pixels.size(); at += sizeof(FloatTexel)) {
        FloatTexel texel;
        if (areFloats)
            texel = floatsAt(from);
        else
            std::ranges::transform(rgbaOf(image.format, from), texel.begin(),
                                   [](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
        if (bits == 16)
            std::ranges::transform(texel, texel.begin(), roundedToHalf);
        storeFloats(texel, floats.pixels.data() + at);
        from += bytesPerPixel(image.format);
    }
    return floats;
}

} // namespace texplorer
