#pragma once

// Turning a compressed picture around without decompressing it.
//
// A block row of texels is a field of bits of the same width in every block, so a flip moves fields and never
// touches colours: what is flipped twice is byte for byte what it was.

#include "core/base/result.h"
#include "core/image/block_image.h"
#include "core/s3tc/encode.h"

#include <string_view>

namespace texplorer {

/// Turns a compressed image upside down in place without decompressing it: the blocks' rows are swapped, and
/// the texel rows within each block. Lossless for height 1, 2, 3 and every multiple of 4 (each slice of a
/// volume). For every other height the rows of the last, partial block row would have to move between blocks:
/// refused (ErrorCode::Unsupported), nothing is changed. Refused too (ErrorCode::Malformed) where `blocks`
/// has not the size that the extents ask for.
///
/// A picture lower than a block is turned around within its one row of blocks: of height 2 the first two
/// texel rows change places, of height 3 the first and the third, and of height 1 nothing changes. Rows that
/// lie outside of the picture keep their bits.
[[nodiscard]] Result<void> flipVertically(BlockImage& image);

/// Left to right, under the same rule for the width.
[[nodiscard]] Result<void> flipHorizontally(BlockImage& image);

/// Both: turned by 180 degrees.
[[nodiscard]] Result<void> rotateHalfTurn(BlockImage& image);

/// Whether a flip along an axis of this extent is lossless; `losslessExtents` names those that are.
[[nodiscard]] constexpr bool flipsWithoutLoss(int extent) {
    return (extent >= 1 && extent <= 3) || extent % 4 == 0;
}

inline constexpr std::string_view losslessExtents = "1, 2, 3 or a multiple of 4";

enum class FlipAxis : std::uint8_t { Vertical, Horizontal, Both };

/// The lossy way, for extents that the functions above refuse: decompresses, turns the pixels around and
/// compresses them again. What is lost depends on `quality`. Errors are those of encodeBlocks: signed formats
/// and volumes can't be turned around this way.
[[nodiscard]] Result<BlockImage> decodeFlipEncode(const BlockImage& image, FlipAxis axis,
                                                  EncodeQuality quality, const Progress& progress = {},
                                                  std::stop_token stop = {});

} // namespace texplorer
