#include "texplorer/image/mirror.h"
#include "texplorer/image/texture_image.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/s3tc/flip.h"

namespace texplorer {

Result<BlockImage> decodeFlipEncode(const BlockImage& image, FlipAxis axis, EncodeQuality quality,
                                    const Progress& progress, std::stop_token stop) {
    if (Result<void> sound = checkBlocks(image); !sound)
        return fail(sound.error());
    Image pixels = decodeBlocks(image);
    if (axis != FlipAxis::Horizontal)
        flipVertically(pixels);
    if (axis != FlipAxis::Vertical)
        mirror(pixels);
    return encodeBlocks(pixels, image.format, quality, progress, std::move(stop));
}

} // namespace texplorer
