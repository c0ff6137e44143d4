#pragma once

#include "core/base/result.h"
#include "core/s3tc/block_image.h"

namespace texplorer {

/// Turns a compressed image upside down in place without decompressing it: the blocks' rows are swapped, and
/// the texel rows within each block. Lossless for height 1, 2 and every multiple of 4 (each slice of a
/// volume). For every other height the rows of the last, partial block row would have to move between blocks:
/// refused, nothing is changed.
[[nodiscard]] Result<void> flipVertically(BlockImage& image);

/// Left to right, under the same rule for the width.
[[nodiscard]] Result<void> flipHorizontally(BlockImage& image);

/// Both: turned by 180 degrees.
[[nodiscard]] Result<void> rotateHalfTurn(BlockImage& image);

/// Whether a flip along an axis of this extent is lossless: 1, 2 or a multiple of 4.
[[nodiscard]] constexpr bool flipsWithoutLoss(int extent) {
    return extent == 1 || extent == 2 || extent % 4 == 0;
}

} // namespace texplorer
