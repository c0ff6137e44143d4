#pragma once

// A metric's value of every pixel, to hold against what others make of the same pictures.

#include "texplorer/compare/pixel_metric.h"

#include <vector>

namespace texplorer::test {

/// From the upper left; the whole picture as one tile.
[[nodiscard]] inline std::vector<float> valuesOf(const Image& expected, const Image& actual,
                                                 const Criterion& criterion, const Image* mask = nullptr) {
    const Tile whole{0, 0, expected.width, expected.height};
    const PicturePair pair(expected, actual, mask);
    const bool opaque = criterion.compared == Compared::Rgb || pair.isOpaque(0, expected.height);
    const std::unique_ptr<PixelMetric> metric = makePixelMetric(criterion, opaque, whole);
    TilePixels pixels;
    pair.read(whole, metric->reach(), pixels);
    std::vector<float> values(static_cast<std::size_t>(whole.width) * static_cast<std::size_t>(whole.height));
    metric->measure(pixels, values);
    return values;
}

/// One colour; row and pixel don't matter.
[[nodiscard]] inline Image even(int width, int height, PixelBytes color) {
    Image image = Image::uninitialised(PixelFormat::Rgba8, width, height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(color[i % 4]);
    return image;
}

/// `x` and `y` from the upper left.
inline void setPixel(Image& image, int x, int y, PixelBytes color) {
    for (std::size_t c = 0; c < color.size(); ++c)
        image.at(x, image.height - 1 - y)[c] = static_cast<std::byte>(color[c]);
}

} // namespace texplorer::test
