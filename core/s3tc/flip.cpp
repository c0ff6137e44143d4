#include "texplorer/s3tc/flip.h"

#include "texplorer/s3tc/block_flip.h"

#include <algorithm>

namespace texplorer {
namespace {

Result<void> checkExtent(const char* name, int extent) {
    if (flipsWithoutLoss(extent))
        return {};
    return fail(ErrorCode::Unsupported,
                Sentence("a compressed picture of {0} {1} can't be flipped without loss: expected {2}", name,
                         extent, losslessExtents));
}

/// How many texels of a block are turned around along an axis of this extent.
int turned(int extent) {
    return std::min(extent, 4);
}

} // namespace

Result<void> flipVertically(BlockImage& image) {
    if (auto sound = checkBlocks(image).and_then([&] { return checkExtent("height", image.height); }); !sound)
        return sound;
    if (image.height == 1)
        return {};
    const BlockFlip flip(image.format, turned(image.height), 1);
    const std::size_t rowBytes = image.blockRowBytes();
    const std::size_t rows = image.blockRows();
    std::byte* slice = image.blocks.data();
    for (int z = 0; z < image.depth; ++z, slice += rows * rowBytes)
        for (std::size_t low = 0, high = rows; low < high; ++low) {
            --high; // where an odd number of rows meets, the two are the same
            swapFlipped(flip, slice + low * rowBytes, slice + high * rowBytes, rowBytes);
        }
    return {};
}

Result<void> flipHorizontally(BlockImage& image) {
    if (auto sound = checkBlocks(image).and_then([&] { return checkExtent("width", image.width); }); !sound)
        return sound;
    const BlockFlip flip(image.format, 1, turned(image.width));
    const std::size_t rowBytes = image.blockRowBytes();
    for (std::size_t at = 0; at < image.blocks.size(); at += rowBytes)
        reverseFlipped(flip, image.blocks.data() + at, rowBytes);
    return {};
}

Result<void> rotateHalfTurn(BlockImage& image) {
    if (auto sound =
            checkBlocks(image).and_then([&] { return checkExtent("height", image.height); }).and_then([&] {
                return checkExtent("width", image.width);
            });
        !sound)
        return sound;
    const BlockFlip flip(image.format, turned(image.height), turned(image.width));
    const std::size_t sliceBytes = image.blockRowBytes() * image.blockRows();
    for (std::size_t at = 0; at < image.blocks.size(); at += sliceBytes)
        reverseFlipped(flip, image.blocks.data() + at, sliceBytes);
    return {};
}

} // namespace texplorer
