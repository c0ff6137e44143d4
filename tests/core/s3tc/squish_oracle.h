#pragma once

// libsquish as an oracle.

#include "texplorer/image/block_image.h"
#include "texplorer/image/image.h"

#include <cstring>
#include <squish.h>

namespace texplorer {

/// libsquish's number for a format; 0 for the signed ones, which it doesn't know.
inline int squishFlag(BlockFormat format) {
    switch (format) {
    case BlockFormat::Dxt1:
    case BlockFormat::Dxt1Alpha:
        return squish::kDxt1;
    case BlockFormat::Dxt3:
        return squish::kDxt3;
    case BlockFormat::Dxt5:
        return squish::kDxt5;
    case BlockFormat::Bc4:
        return squish::kBc4;
    case BlockFormat::Bc5:
        return squish::kBc5;
    case BlockFormat::Bc4Signed:
    case BlockFormat::Bc5Signed:
        break;
    }
    return 0;
}

/// One slice of DXT1, DXT3 or DXT5 as Rgba8.
inline Image decodeWithSquish(const BlockImage& image) {
    Image pixels = Image::uninitialised(PixelFormat::Rgba8, image.width, image.height);
    squish::DecompressImage(reinterpret_cast<squish::u8*>(pixels.pixels.data()), image.width, image.height,
                            image.blocks.data(), squishFlag(image.format));
    return pixels;
}

/// libsquish compresses to BC4 and BC5 and doesn't decompress them; but each of their channels is the alpha
/// of a DXT5 block: the one that `image` holds in the given half of its blocks.
inline BlockImage asDxt5Alpha(const BlockImage& image, std::size_t half) {
    BlockImage alpha = BlockImage::uninitialised(BlockFormat::Dxt5, image.width, image.height);
    const std::size_t step = bytesPerBlock(image.format);
    for (std::size_t block = 0; block < image.blocks.size() / step; ++block) {
        std::memcpy(&alpha.blocks[16 * block], &image.blocks[step * block + 8 * half], 8);
        std::memset(&alpha.blocks[16 * block + 8], 0, 8);
    }
    return alpha;
}

} // namespace texplorer
