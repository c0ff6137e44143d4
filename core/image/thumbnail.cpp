#include "texplorer/image/thumbnail.h"

#include "texplorer/image/convert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texplorer {

namespace {

using Premultiplied = std::array<double, 4>; // colours times alpha, and alpha, 0 to 255

Premultiplied colorOf(PixelFormat format, ByteView pixel) {
    const auto value = [&](std::size_t index) { return std::to_integer<int>(pixel[index]); };
    const auto times = [](int r, int g, int b, int a) {
        const double share = a / 255.0;
        return Premultiplied{r * share, g * share, b * share, static_cast<double>(a)};
    };
    switch (format) {
    case PixelFormat::Alpha8:
        return times(255, 255, 255, value(0));
    case PixelFormat::Luminance8:
        return times(value(0), value(0), value(0), 255);
    case PixelFormat::LuminanceAlpha8:
        return times(value(0), value(0), value(0), value(1));
    case PixelFormat::Rgb8:
        return times(value(0), value(1), value(2), 255);
    case PixelFormat::Rgba8:
        return times(value(0), value(1), value(2), value(3));
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat: {
        const auto [r, g, b, a] = rgbaOf(format, pixel.data());
        return times(r, g, b, a);
    }
    }
    return {};
}

/// The texels that a pixel of the small picture covers, the first and the last one perhaps in part.
struct Span {
    int first;
    int last;
    double low;
    double high;

    Span(int index, int count, int texels)
        : first(0)
        , last(0)
        , low(static_cast<double>(index) * texels / count)
        , high(static_cast<double>(index + 1) * texels / count) {
        first = static_cast<int>(low);
        last = std::min(texels, static_cast<int>(std::ceil(high)));
    }
    [[nodiscard]] double share(int texel) const {
        return std::min(high, static_cast<double>(texel + 1)) - std::max(low, static_cast<double>(texel));
    }
};

int scaled(int extent, int maxExtent, int largest) {
    const double size = static_cast<double>(extent) * maxExtent / largest;
    return std::max(1, static_cast<int>(std::lround(size)));
}

} // namespace

Image thumbnailOf(const Image& image, int maxExtent) {
    if (image.empty())
        return {};
    const int largest = std::max({image.width, image.height, maxExtent});
    Image small = Image::uninitialised(PixelFormat::Rgba8, scaled(image.width, maxExtent, largest),
                                       scaled(image.height, maxExtent, largest));
    if (largest == maxExtent)
        small = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    for (int y = 0; y < small.height; ++y) {
        const Span rows(y, small.height, image.height);
        for (int x = 0; x < small.width; ++x) {
            const Span columns(x, small.width, image.width);
            Premultiplied sum{};
            double area = 0;
            for (int v = rows.first; v < rows.last; ++v) {
                for (int u = columns.first; u < columns.last; ++u) {
                    const double weight = rows.share(v) * columns.share(u);
                    const Premultiplied color = colorOf(image.format, image.at(u, v));
                    for (std::size_t i = 0; i < sum.size(); ++i)
                        sum[i] += weight * color[i];
                    area += weight;
                }
            }
            const double alpha = sum[3] / area;
            const std::span<std::byte> to = small.at(x, y);
            for (std::size_t i = 0; i < 3; ++i) {
                const double color = alpha > 0 ? sum[i] / area * 255 / alpha : 0;
                to[i] = static_cast<std::byte>(std::clamp(std::lround(color), 0L, 255L));
            }
            to[3] = static_cast<std::byte>(std::clamp(std::lround(alpha), 0L, 255L));
        }
    }
    return small;
}

} // namespace texplorer
