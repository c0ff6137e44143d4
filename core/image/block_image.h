#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/gl/block_format.h"

namespace texplorer {

/// A compressed picture or volume: rows of ceil(width / 4) blocks, ceil(height / 4) rows, `depth` slices. Its
/// owner defines the order of the rows (TextureImage::topFirst).
struct BlockImage {
    BlockFormat format = BlockFormat::Dxt1;
    int width = 0;
    int height = 0;
    int depth = 1;
    Bytes blocks; ///< byteCount() bytes

    [[nodiscard]] static BlockImage uninitialised(BlockFormat format, int width, int height, int depth = 1) {
        BlockImage image{format, width, height, depth, {}};
        image.blocks.resize(image.byteCount());
        return image;
    }
    /// The size of `blocks`, or what it would be in an outline.
    [[nodiscard]] std::size_t byteCount() const {
        return blockRowBytes() * blockRows() * static_cast<std::size_t>(depth);
    }
    [[nodiscard]] std::size_t blockRowBytes() const {
        return (static_cast<std::size_t>(width) + 3) / 4 * bytesPerBlock(format);
    }
    [[nodiscard]] std::size_t blockRows() const { return (static_cast<std::size_t>(height) + 3) / 4; }

    bool operator==(const BlockImage&) const = default;
};

/// Malformed if the size of `blocks` does not match the extents, or an extent is not positive.
[[nodiscard]] Result<void> checkBlocks(const BlockImage& image);

} // namespace texplorer
