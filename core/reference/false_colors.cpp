#include "texplorer/reference/false_colors.h"

#include "texplorer/image/color_scale.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace texplorer::reference {

std::array<std::uint8_t, 4> lambdaColor(float lambda, int steps) {
    if (!(lambda > 0))
        return {0, 0, 0, 255};
    return viridis(lambda / static_cast<float>(steps));
}

std::array<std::uint8_t, 4> ratioColor(float ratio) {
    return viridis(std::log2(std::max(1.0F, ratio)) / std::log2(maxShownRatio));
}

int stepsOf(const LevelMap& map) {
    return std::max(1, map.lastLevel - map.sampler.baseLevel);
}

Image falseColors(const LevelMap& map, Shown shown) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, map.width, map.height);
    const int steps = stepsOf(map);
    std::byte* to = image.pixels.data();
    for (const PixelLevels& pixel : map.pixels) {
        std::array<std::uint8_t, 4> color{};
        if (pixel.isSampled() && shown == Shown::Lambda)
            color = lambdaColor(pixel.lambda, steps);
        else if (pixel.isSampled() && shown == Shown::Anisotropy)
            color = ratioColor(pixel.ratio);
        std::memcpy(to, color.data(), color.size());
        to += color.size();
    }
    return image;
}

} // namespace texplorer::reference
