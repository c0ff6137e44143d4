#include "texplorer/image/resample.h"

#include "texplorer/image/linear_light.h"

// The functions are static here, so that a program may bring its own copy of the library.
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#include <algorithm>
#include <cstring>
#include <stb/stb_image_resize.h>

namespace texplorer {

namespace {

// Which texels of a line of `extent` lie below texel `index` of a line of `scaled`, and how much of each.
// Texel i covers [i * scaled, (i + 1) * scaled), the new one [index * extent, (index + 1) * extent): whole
// numbers with the sum `extent`, 3 -> 4 for example:
//
//   |    0    |    1    |    2    |
//   |  0   |   1   |   2   |  3   |      weights: 3 | 1 2 | 2 1 | 3
struct Cover {
    int first = 0;
    std::vector<std::uint64_t> weights;
};

std::vector<Cover> coversOf(int extent, int scaled) {
    std::vector<Cover> covers(static_cast<std::size_t>(scaled));
    for (std::int64_t index = 0; index < scaled; ++index) {
        Cover& cover = covers[static_cast<std::size_t>(index)];
        const std::int64_t begin = index * extent;
        const std::int64_t end = begin + extent;
        cover.first = static_cast<int>(begin / scaled);
        for (std::int64_t i = cover.first; i * scaled < end; ++i)
            cover.weights.push_back(
                static_cast<std::uint64_t>(std::min(end, (i + 1) * scaled) - std::max(begin, i * scaled)));
    }
    return covers;
}

/// How components are read, added up exactly enough, and written.
struct ByteSums {
    using Sum = std::uint64_t;
    static constexpr std::size_t size = 1;
    static Sum read(const std::byte* component) { return std::to_integer<Sum>(*component); }
    static void write(Sum sum, std::uint64_t total, std::byte* component) {
        *component = static_cast<std::byte>((sum + total / 2) / total);
    }
};
struct FloatSums {
    using Sum = double;
    static constexpr std::size_t size = sizeof(float);
    static Sum read(const std::byte* component) {
        float value = 0;
        std::memcpy(&value, component, size);
        return value;
    }
    static void write(Sum sum, std::uint64_t total, std::byte* component) {
        const auto value = static_cast<float>(sum / static_cast<double>(total));
        std::memcpy(component, &value, size);
    }
};

template<class Sums>
void scale(const Image& from, Image& to) {
    const std::vector<Cover> columns = coversOf(from.width, to.width);
    const std::vector<Cover> rows = coversOf(from.height, to.height);
    const std::vector<Cover> slices = coversOf(from.depth, to.depth);
    const std::uint64_t total = static_cast<std::uint64_t>(from.width) *
                                static_cast<std::uint64_t>(from.height) *
                                static_cast<std::uint64_t>(from.depth);
    const std::size_t components = static_cast<std::size_t>(bytesPerPixel(from.format)) / Sums::size;
    using Sum = typename Sums::Sum;
    std::vector<Sum> sums(from.rowBytes() / Sums::size);
    std::byte* out = to.pixels.data();
    for (const Cover& slice : slices)
        for (const Cover& row : rows) {
            std::ranges::fill(sums, Sum{});
            for (std::size_t z = 0; z < slice.weights.size(); ++z)
                for (std::size_t y = 0; y < row.weights.size(); ++y) {
                    const auto weight = static_cast<Sum>(slice.weights[z] * row.weights[y]);
                    const std::byte* source =
                        from.pixels.data() +
                        from.offset(0, row.first + static_cast<int>(y), slice.first + static_cast<int>(z));
                    for (std::size_t i = 0; i < sums.size(); ++i)
                        sums[i] += weight * Sums::read(source + i * Sums::size);
                }
            for (const Cover& column : columns) {
                const Sum* texel = sums.data() + static_cast<std::size_t>(column.first) * components;
                for (std::size_t c = 0; c < components; ++c, out += Sums::size) {
                    Sum sum{};
                    for (std::size_t x = 0; x < column.weights.size(); ++x)
                        sum += static_cast<Sum>(column.weights[x]) * texel[x * components + c];
                    Sums::write(sum, total, out);
                }
            }
        }
}

stbir_filter stbFilter(MipFilter filter) {
    switch (filter) {
    case MipFilter::Box:
        return STBIR_FILTER_BOX;
    case MipFilter::Triangle:
        return STBIR_FILTER_TRIANGLE;
    case MipFilter::Cubic:
        return STBIR_FILTER_CUBICBSPLINE;
    case MipFilter::CatmullRom:
        return STBIR_FILTER_CATMULLROM;
    case MipFilter::Mitchell:
        return STBIR_FILTER_MITCHELL;
    }
    return STBIR_FILTER_BOX;
}

} // namespace

int nearestPowerOfTwo(int extent) {
    int power = 1;
    while (power <= extent / 2)
        power *= 2;
    return 2 * (extent - power) >= power ? 2 * power : power;
}

Image scaleByCoverage(const Image& from, int width, int height, int depth) {
    Image to = Image::uninitialised(from.format, width, height, depth);
    if (from.format == PixelFormat::RgbaFloat)
        scale<FloatSums>(from, to);
    else
        scale<ByteSums>(from, to);
    return to;
}

Image toPowerOfTwo(Image image) {
    const int width = nearestPowerOfTwo(image.width);
    const int height = nearestPowerOfTwo(image.height);
    const int depth = nearestPowerOfTwo(image.depth);
    if (image.empty() || (width == image.width && height == image.height && depth == image.depth))
        return image;
    return scaleByCoverage(image, width, height, depth);
}

Image scaleFiltered(const Image& from, int width, int height, MipFilter filter, bool linearLight) {
    Image to = Image::uninitialised(from.format, width, height, from.depth);
    const int alpha = alphaComponent(from.format);
    // "Premultiplied" keeps stb from weighting colours with alpha: GL filters each component by itself.
    constexpr int apart = STBIR_FLAG_ALPHA_PREMULTIPLIED;
    for (int z = 0; z < from.depth; ++z)
        stbir_resize_uint8_generic(
            reinterpret_cast<const unsigned char*>(from.pixels.data() + from.offset(0, 0, z)), from.width,
            from.height, 0, reinterpret_cast<unsigned char*>(to.pixels.data() + to.offset(0, 0, z)), width,
            height, 0, bytesPerPixel(from.format), alpha < 0 ? STBIR_ALPHA_CHANNEL_NONE : alpha, apart,
            STBIR_EDGE_CLAMP, stbFilter(filter),
            linearLight ? STBIR_COLORSPACE_SRGB : STBIR_COLORSPACE_LINEAR, nullptr);
    return to;
}

} // namespace texplorer
