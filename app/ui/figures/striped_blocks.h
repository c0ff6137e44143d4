#pragma once

#include "core/image/block_image.h"
#include "core/s3tc/block_parts.h"

namespace texplorer::ui {

/// A picture of one block's width whose rows can be told apart: each has a colour of its own, and in DXT3 and
/// DXT5 an alpha that differs from those of the rows around it. Those that the last block has beyond the
/// height, too. For heights up to 12.
[[nodiscard]] BlockImage stripedBlocks(BlockFormat format, int height);

/// A row of blocks of such a picture.
[[nodiscard]] BlockBytes blockAt(const BlockImage& image, int blockRow);

/// Which row of `original` a row of blocks of `image` has as its texel row; -1: none.
[[nodiscard]] int stripeAt(const BlockImage& image, const BlockImage& original, int row);

} // namespace texplorer::ui
