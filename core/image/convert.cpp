#include "texplorer/image/convert.h"

#include <cstring>

namespace texplorer {

Image asRgba(Image image) {
    if (image.format == PixelFormat::Rgba8)
        return image;
    Image out = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height, image.depth);
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    for (std::size_t from = 0, to = 0; from < image.pixels.size(); from += step, to += 4) {
        const auto texel = rgbaOf(image.format, image.pixels.data() + from);
        std::memcpy(out.pixels.data() + to, texel.data(), texel.size());
    }
    return out;
}

Image asBytes(Image image) {
    return image.format == PixelFormat::RgbaFloat ? asRgba(std::move(image)) : greysOf(std::move(image));
}

Image withoutAlpha(Image image) {
    if (image.format != PixelFormat::Rgba8)
        return image;
    // In place: what is written never overtakes what is read.
    std::byte* to = image.pixels.data();
    const std::byte* end = to + image.pixels.size();
    for (const std::byte* from = to; from != end; from += 4, to += 3) {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
    }
    image.format = PixelFormat::Rgb8;
    image.pixels.resize(image.pixels.size() / 4 * 3);
    return image;
}

} // namespace texplorer
