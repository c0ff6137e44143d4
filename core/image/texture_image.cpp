#include "texplorer/image/texture_image.h"

#include <algorithm>

namespace texplorer {

int widthOf(const Surface& surface) {
    return std::visit([](const auto& image) { return image.width; }, surface);
}

int heightOf(const Surface& surface) {
    return std::visit([](const auto& image) { return image.height; }, surface);
}

int depthOf(const Surface& surface) {
    return std::visit([](const auto& image) { return image.depth; }, surface);
}

std::size_t byteCount(const Surface& surface) {
    return std::visit([](const auto& image) { return image.byteCount(); }, surface);
}

std::size_t byteCount(const TextureImage& texture) {
    std::size_t bytes = 0;
    for (const Surface& surface : texture.surfaces)
        bytes += byteCount(surface);
    return bytes;
}

std::size_t bytesHeld(const Surface& surface) {
    if (const Image* image = std::get_if<Image>(&surface))
        return image->pixels.size();
    return std::get<BlockImage>(surface).blocks.size();
}

bool hasPixels(const TextureImage& texture) {
    return !texture.surfaces.empty() && bytesHeld(texture.surfaces.front()) > 0;
}

void flipVertically(Image& image) {
    const std::size_t row = image.rowBytes();
    for (int z = 0; z < image.depth; ++z) {
        std::byte* low = image.pixels.data() + image.offset(0, 0, z);
        std::byte* high = image.pixels.data() + image.offset(0, image.height - 1, z);
        for (; low < high; low += row, high -= row)
            std::swap_ranges(low, low + row, high);
    }
}

TextureImage textureOf(Image image, std::string_view format) {
    TextureImage texture;
    texture.format = format;
    const bool hasAlpha = image.format == PixelFormat::Rgba8 ||
                          image.format == PixelFormat::LuminanceAlpha8 || image.format == PixelFormat::Alpha8;
    texture.alpha = hasAlpha ? AlphaMeaning::Straight : AlphaMeaning::None;
    texture.surfaces.emplace_back(std::move(image));
    return texture;
}

} // namespace texplorer
