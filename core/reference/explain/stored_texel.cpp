#include "texplorer/reference/explain/stored_texel.h"

#include "texplorer/image/linear_light.h"
#include "texplorer/image/stored_numbers.h"

#include <algorithm>
#include <cmath>

namespace texplorer::reference {

namespace {

/// The bits behind each component of a texture source colour (OpenGL 2.1, table 3.20).
std::array<std::uint8_t, 4> bitsBehind(const FormatFacts& facts) {
    const auto& bits = facts.bits;
    switch (facts.base) {
    case BaseFormat::Luminance:
    case BaseFormat::LuminanceAlpha:
        return {bits[0], bits[0], bits[0], bits[3]};
    case BaseFormat::Intensity:
        return {bits[0], bits[0], bits[0], bits[0]};
    default:
        return bits;
    }
}

bool isExplained(InternalFormat format) {
    return isSrgb(format) || hasFewBits(format);
}

/// The byte that has so much light by sRGB's curve.
int srgbByte(float light) {
    const auto& exact = LinearLight::table().exactLight;
    return static_cast<int>(std::ranges::lower_bound(exact, light) - exact.begin());
}

} // namespace

std::optional<StoredTexel> storedTexel(InternalFormat format, glm::vec4 color) {
    if (!isExplained(format))
        return std::nullopt;
    const std::array<std::uint8_t, 4> bits = bitsBehind(factsOf(format));
    StoredTexel stored;
    for (std::size_t i = 0; i < bits.size(); ++i) {
        if (bits[i] == 0)
            continue;
        const float value = color[static_cast<int>(i)];
        stored.max[i] = maxNumber(bits[i]);
        stored.numbers[i] = isSrgb(format) && i < 3
                                ? srgbByte(value)
                                : static_cast<int>(std::lround(value * static_cast<float>(stored.max[i])));
    }
    return stored;
}

Sentence storedSentence(InternalFormat format) {
    if (!isExplained(format))
        return {};
    const ProperName name{rowOf(format).name};
    if (isSrgb(format))
        return Sentence(
            "{0} converts colours to light: c / 12.92 up to 0.04045, else ((c + 0.055) / 1.055)^2.4.", name);
    return Sentence("{0} has few bits: a stored number is divided by the largest.", name);
}

} // namespace texplorer::reference
