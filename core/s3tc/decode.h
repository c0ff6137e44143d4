#pragma once

#include "core/image/block_image.h"
#include "core/image/image.h"

#include <span>

namespace texplorer {

/// Decompresses to Rgba8, rows in the order of the blocks. Colours of DXT1/3/5: 5 and 6 bits are widened by
/// repeating their top bits; the colours between are (2a + b) / 3 and (a + b) / 2 in integers, rounded down,
/// as libsquish does it; the specification leaves the rounding open. BC4 becomes grey in red, green and blue;
/// BC5 red and green with blue 0; signed values map -1..1 to 0..255, and -128 counts as -127, as
/// ARB_texture_compression_rgtc says; of -127 and -128 the first is larger (it leaves that undefined,
/// llvmpipe does the same). What lies between two values is cut off towards 0. Single-threaded.
///
/// Mesa's llvmpipe, read with glGetTexImage, gives the ends as we do, and what lies between them otherwise.
/// Colours differ by at most 1: halves it rounds up, and its thirds fall a little short of the second colour,
/// as do the values of DXT5, BC4 and BC5. Those it makes as a + ((b - a) * w >> 8) with w = 255 * share of b,
/// cut off: divided by 256 where it should be 255, and the shift rounds down whatever the sign. So 255 and 46
/// with code 7, exactly 75.9, are 75 here and 77 there. Over all pairs of values that is at most 2, and 3 for
/// signed ones, where we cut off towards 0 from both sides (tests/render/s3tc_test.cpp).
[[nodiscard]] Image decodeBlocks(const BlockImage& image);

/// The same into memory that is there already: width * height * depth texels of 4 bytes, without padding.
void decodeBlocks(const BlockImage& image, std::span<std::byte> rgba);

/// One block to 4 x 4 Rgba8 texels, row by row: the literal text of the specification, and decodeBlocks'
/// oracle.
void decodeBlock(BlockFormat format, const std::byte* block, std::byte* rgba);

} // namespace texplorer
