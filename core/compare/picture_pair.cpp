#include "texplorer/compare/picture_pair.h"

#include "texplorer/image/convert.h"
#include "texplorer/image/linear_light.h"

#include <algorithm>
#include <cstring>

namespace texplorer {

namespace {

/// The pixels [first, first + count) of a row that the picture has; `y` is counted from the top.
void readPixels(const Image& image, int first, int count, int y, PixelBytes* to) {
    const std::byte* from = image.at(first, image.height - 1 - y).data();
    if (image.format == PixelFormat::Rgba8) {
        std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(PixelBytes));
        return;
    }
    const int bytes = bytesPerPixel(image.format);
    for (int i = 0; i < count; ++i)
        to[i] = rgbaOf(image.format, from + static_cast<std::ptrdiff_t>(i) * bytes);
}

/// The same with the nearest pixels of the row where the picture ends.
void readRow(const Image& image, int first, int count, int y, PixelBytes* to) {
    const int inside = std::clamp(first, 0, image.width - 1);
    const int end = std::clamp(first + count, inside + 1, image.width);
    PixelBytes* const begin = to + (inside - first);
    readPixels(image, inside, end - inside, std::clamp(y, 0, image.height - 1), begin);
    std::fill(to, begin, *begin);
    std::fill(begin + (end - inside), to + count, begin[end - inside - 1]);
}

PixelBytes meanOf(const PixelBytes& a, const PixelBytes& b) {
    PixelBytes mean{};
    for (std::size_t c = 0; c < mean.size(); ++c)
        mean[c] = static_cast<std::uint8_t>((a[c] + b[c] + 1) / 2);
    return mean;
}

bool hasOpaqueRows(const Image& image, int first, int count) {
    const int alpha = alphaComponent(image.format);
    if (alpha < 0)
        return true;
    const auto step = static_cast<std::size_t>(bytesPerPixel(image.format));
    const std::size_t end = static_cast<std::size_t>(first + count) * image.rowBytes();
    for (std::size_t i = static_cast<std::size_t>(first) * image.rowBytes() + static_cast<std::size_t>(alpha);
         i < end; i += step)
        if (image.pixels[i] != std::byte{255})
            return false;
    return true;
}

} // namespace

void PicturePair::read(const Tile& tile, int reach, TilePixels& pixels) const {
    pixels.tile = tile;
    pixels.reach = reach;
    const int width = pixels.width();
    const int height = pixels.height();
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    pixels.expected.resize(count);
    pixels.actual.resize(count);
    pixels.counts.assign(static_cast<std::size_t>(tile.width) * static_cast<std::size_t>(tile.height), 1);
    std::vector<PixelBytes> mask(mask_ != nullptr ? static_cast<std::size_t>(width) : 0);
    for (int y = 0; y < height; ++y) {
        const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
        readRow(*expected_, tile.x - reach, width, tile.y + y - reach, &pixels.expected[row]);
        readRow(*actual_, tile.x - reach, width, tile.y + y - reach, &pixels.actual[row]);
        if (mask_ == nullptr)
            continue;
        readRow(*mask_, tile.x - reach, width, tile.y + y - reach, mask.data());
        for (int x = 0; x < width; ++x) {
            if (!isMasked(mask[static_cast<std::size_t>(x)]))
                continue;
            const std::size_t i = row + static_cast<std::size_t>(x);
            pixels.expected[i] = pixels.actual[i] = meanOf(pixels.expected[i], pixels.actual[i]);
            const int tileX = x - reach;
            const int tileY = y - reach;
            if (tileX >= 0 && tileX < tile.width && tileY >= 0 && tileY < tile.height)
                pixels.counts[static_cast<std::size_t>(tileY) * static_cast<std::size_t>(tile.width) +
                              static_cast<std::size_t>(tileX)] = 0;
        }
    }
}

bool PicturePair::isOpaque(int first, int count) const {
    return hasOpaqueRows(*expected_, first, count) && hasOpaqueRows(*actual_, first, count);
}

} // namespace texplorer
