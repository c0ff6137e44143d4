#include "texplorer/image/stored_numbers.h"

#include "texplorer/image/convert.h"

namespace texplorer {

Image withStoredNumbers(const Image& image, InternalFormat format) {
    if (!hasFewBits(format))
        return image;
    std::array<std::array<std::byte, 256>, 4> kept{};
    for (std::size_t component = 0; component < kept.size(); ++component) {
        const int bits = factsOf(format).bits[component];
        for (int byte = 0; byte < 256; ++byte)
            kept[component][static_cast<std::size_t>(byte)] =
                static_cast<std::byte>(bits == 0 ? byte : byteOf(storedNumber(byte, bits), bits));
    }
    Image stored = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height, image.depth);
    std::byte* to = stored.pixels.data();
    const std::byte* const end = to + stored.pixels.size();
    for (const std::byte* from = image.pixels.data(); to != end; from += bytesPerPixel(image.format)) {
        const std::array<std::uint8_t, 4> rgba = rgbaOf(image.format, from);
        for (std::size_t component = 0; component < 4; ++component)
            *to++ = kept[component][rgba[component]];
    }
    return stored;
}

} // namespace texplorer
