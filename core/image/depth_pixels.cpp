#include "texplorer/image/depth_pixels.h"

namespace texplorer {

namespace {

/// Its red.
std::uint32_t depthOf(PixelFormat format, const std::byte* pixel) {
    if (format == PixelFormat::Depth32)
        return depthAt(pixel);
    if (format == PixelFormat::Alpha8)
        return 0;
    return widenedDepth(std::to_integer<std::uint32_t>(*pixel), 8);
}

} // namespace

Image depthsOf(const Image& image, int bits) {
    Image depths = Image::uninitialised(PixelFormat::Depth32, image.width, image.height, image.depth);
    const std::uint64_t max = (std::uint64_t{1} << bits) - 1;
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    const std::byte* from = image.pixels.data();
    for (std::size_t at = 0; at < depths.pixels.size(); at += sizeof(std::uint32_t), from += step) {
        const std::uint64_t kept =
            (depthOf(image.format, from) * max + farthestDepth32 / 2) / farthestDepth32;
        storeDepth(widenedDepth(static_cast<std::uint32_t>(kept), bits), depths.pixels.data() + at);
    }
    return depths;
}

Image greysOf(Image image) {
    if (image.format != PixelFormat::Depth32)
        return image;
    Image greys = Image::uninitialised(PixelFormat::Luminance8, image.width, image.height, image.depth);
    for (std::size_t i = 0; i < greys.pixels.size(); ++i)
        greys.pixels[i] =
            static_cast<std::byte>(greyOfDepth(depthAt(image.pixels.data() + i * sizeof(std::uint32_t))));
    return greys;
}

} // namespace texplorer
