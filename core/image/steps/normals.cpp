#include "texplorer/image/steps/image_steps.h"
#include "texplorer/image/steps/step_texels.h"

#include <cmath>
#include <vector>

namespace texplorer {
namespace {

std::uint8_t stored(double component) {
    return static_cast<std::uint8_t>(std::lround((component * 0.5 + 0.5) * 255));
}

Components normalOf(double slopeX, double slopeY, std::uint8_t alpha) {
    const double length = std::sqrt(slopeX * slopeX + slopeY * slopeY + 1);
    return {stored(-slopeX / length), stored(-slopeY / length), stored(1 / length), alpha};
}

} // namespace

Image normalsOf(const Image& heights, float strength, bool topFirst) {
    std::vector<double> height; // 0 to `strength` texels
    height.reserve(heights.pixels.size() / static_cast<std::size_t>(bytesPerPixel(heights.format)));
    const Image grey = eachTexel(heights, PixelFormat::Luminance8, [](const Components& texel, std::size_t) {
        return Components{luminanceOf(texel)};
    });
    for (const std::byte each : grey.pixels)
        height.push_back(std::to_integer<int>(each) / 255.0 * double{strength});
    const int width = heights.width;
    const int rows = heights.height;
    const auto at = [&](int x, int y, int z) {
        return height[grey.offset((x + width) % width, (y + rows) % rows, z)];
    };
    const double up = topFirst ? -1 : 1;
    const PixelFormat format = smallestFormat(false, alphaComponent(heights.format) >= 0);
    return eachTexel(heights, format, [&](const Components& texel, std::size_t i) {
        const int x = static_cast<int>(i % static_cast<std::size_t>(width));
        const auto row = static_cast<int>(i / static_cast<std::size_t>(width));
        const int y = row % rows;
        const int z = row / rows;
        return normalOf((at(x + 1, y, z) - at(x - 1, y, z)) / 2, up * (at(x, y + 1, z) - at(x, y - 1, z)) / 2,
                        texel[3]);
    });
}

} // namespace texplorer
