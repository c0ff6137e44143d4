#pragma once

// Flips compressed pictures without decompression.
//
// A row of texels in a block is a bit field of the same width in every block, so a flip moves fields and
// never changes colours: flipping twice restores every byte.

#include "texplorer/base/result.h"
#include "texplorer/image/block_image.h"
#include "texplorer/s3tc/encode.h"

#include <string_view>

namespace texplorer {

/// Flips a compressed image upside down in place, without decompression: the rows of blocks are swapped, and
/// the texel rows in each block. Lossless for height 1, 2, 3 and every multiple of 4 (for each slice of a
/// volume). For other heights, the rows of the last, partial block row would have to move between blocks:
/// refused (ErrorCode::Unsupported), and the image is unchanged. ErrorCode::Malformed if the size of `blocks`
/// does not match the extents.
///
/// A picture lower than a block is flipped in its one row of blocks: for height 2, the first two texel rows
/// are swapped; for height 3, the first and the third; for height 1, nothing changes. Rows outside of the
/// picture keep their bits.
[[nodiscard]] Result<void> flipVertically(BlockImage& image);

/// Flips left to right, with the same rule for the width.
[[nodiscard]] Result<void> flipHorizontally(BlockImage& image);

/// Flips both: rotates by 180 degrees.
[[nodiscard]] Result<void> rotateHalfTurn(BlockImage& image);

/// Whether a flip along an axis of this extent is lossless; `losslessExtents` describes these extents.
[[nodiscard]] constexpr bool flipsWithoutLoss(int extent) {
    return (extent >= 1 && extent <= 3) || extent % 4 == 0;
}

inline constexpr std::string_view losslessExtents = N_("1, 2, 3 or a multiple of 4");

enum class FlipAxis : std::uint8_t { Vertical, Horizontal, Both };

/// Flips with loss, for extents that the functions above refuse: decompresses, flips the pixels and
/// compresses them again. The loss depends on `quality`. Errors: those of encodeBlocks; signed formats and
/// volumes are not supported.
[[nodiscard]] Result<BlockImage> decodeFlipEncode(const BlockImage& image, FlipAxis axis,
                                                  EncodeQuality quality, const Progress& progress = {},
                                                  std::stop_token stop = {});

} // namespace texplorer
