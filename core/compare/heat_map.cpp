#include "texplorer/compare/heat_map.h"

#include "texplorer/compare/comparable.h"
#include "texplorer/compare/pixel_difference.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace texplorer {

namespace {

using RampColor = std::array<float, 3>;

/// In a line between these, at equal distances; within the tolerance and above it.
constexpr std::array withinRamp{RampColor{12, 10, 40}, RampColor{38, 36, 112}};
constexpr std::array aboveRamp{RampColor{112, 32, 130}, RampColor{190, 48, 96},  RampColor{232, 92, 44},
                               RampColor{250, 158, 24}, RampColor{248, 220, 96}, RampColor{255, 255, 226}};

std::array<std::uint8_t, 4> between(std::span<const RampColor> colors, float position) {
    const float place = std::clamp(position, 0.0F, 1.0F) * static_cast<float>(colors.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    std::array<std::uint8_t, 4> result{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = static_cast<std::uint8_t>(std::lround(
            std::lerp(colors[first][c], colors[first + 1][c], place - static_cast<float>(first))));
    return result;
}

} // namespace

std::array<std::uint8_t, 4> heatColor(float difference, const HeatScale& scale) {
    const auto tolerance = static_cast<float>(std::max(0, scale.tolerance));
    if (!(difference > 0))
        return {0, 0, 0, 255};
    if (difference <= tolerance)
        return between(withinRamp, difference / tolerance);
    // The smallest difference above the tolerance is tolerance + 1: that is where the second part begins.
    const float lowest = std::log(tolerance + 1);
    const float range = std::log(static_cast<float>(std::max(scale.top, scale.tolerance + 1))) - lowest;
    return between(aboveRamp, range > 0 ? (std::log(difference) - lowest) / range : 1);
}

std::vector<HeatStep> heatSteps(const HeatScale& scale) {
    std::vector<HeatStep> steps;
    for (const int difference : {0, 1, 2, 4, 8, 16, 32, 64, 128, 255})
        steps.push_back({difference, heatColor(static_cast<float>(difference), scale)});
    return steps;
}

Result<Image> heatMap(const Image& a, const Image& b, const HeatScale& scale, Compared compared) {
    if (const Result<void> comparable = checkComparable(a, b); !comparable)
        return fail(comparable.error());
    std::array<std::array<std::uint8_t, 4>, 256> colors{};
    for (std::size_t i = 0; i < colors.size(); ++i)
        colors[i] = heatColor(static_cast<float>(i), scale);
    const std::size_t components = componentsOf(compared);
    const auto* const aBytes = reinterpret_cast<const std::uint8_t*>(a.pixels.data());
    const auto* const bBytes = reinterpret_cast<const std::uint8_t*>(b.pixels.data());
    Image map = Image::uninitialised(PixelFormat::Rgba8, a.width, a.height);
    for (std::size_t i = 0; i < map.pixels.size() / 4; ++i) {
        const int worst = differenceOf(aBytes + i * 4, bBytes + i * 4, components).worst;
        const auto& color = colors[static_cast<std::size_t>(worst)];
        for (std::size_t c = 0; c < 4; ++c)
            map.pixels[i * 4 + c] = static_cast<std::byte>(color[c]);
    }
    return map;
}

} // namespace texplorer
