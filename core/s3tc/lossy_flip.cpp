#include "core/image/texture_image.h"
#include "core/s3tc/decode.h"
#include "core/s3tc/flip.h"

#include <algorithm>
#include <cstring>

namespace texplorer {
namespace {

void flipHorizontally(Image& image) {
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t at = 0; at < image.pixels.size(); at += image.rowBytes())
        for (std::size_t low = 0, high = width - 1; low < high; ++low, --high)
            std::swap_ranges(image.pixels.data() + at + 4 * low, image.pixels.data() + at + 4 * low + 4,
                             image.pixels.data() + at + 4 * high);
}

} // namespace

Result<BlockImage> decodeFlipEncode(const BlockImage& image, FlipAxis axis, EncodeQuality quality,
                                    const Progress& progress, std::stop_token stop) {
    if (Result<void> sound = checkBlocks(image); !sound)
        return fail(sound.error());
    Image pixels = decodeBlocks(image);
    if (axis != FlipAxis::Horizontal)
        flipVertically(pixels);
    if (axis != FlipAxis::Vertical)
        flipHorizontally(pixels);
    return encodeBlocks(pixels, image.format, quality, progress, std::move(stop));
}

} // namespace texplorer
