#pragma once

#include "texplorer/image/block_image.h"
#include "texplorer/image/image.h"

#include <span>

namespace texplorer {

/// Decompresses to Rgba8, rows in the order of the blocks. Colours of DXT1/3/5: 5 and 6 bits are widened by
/// repeating their top bits; the colours between are (2a + b) / 3 and (a + b) / 2 in integers, rounded down,
/// as in libsquish; the specification leaves the rounding open. BC4 becomes grey in red, green and blue; BC5
/// becomes red and green with blue 0; signed values map -1..1 to 0..255, and -128 counts as -127, as in
/// ARB_texture_compression_rgtc; of -127 and -128, the first is larger (that specification leaves it
/// undefined; llvmpipe does the same). Values between two others are rounded towards 0. Single-threaded.
///
/// Mesa's llvmpipe, read with glGetTexImage, gives the same ends, but other values between them. Colours
/// differ by at most 1: halves are rounded up, and its thirds are a little too far from the second colour, as
/// are the values of DXT5, BC4 and BC5. These are computed as a + ((b - a) * w >> 8) with w = 255 * share of
/// b, rounded down: it divides by 256 instead of 255, and the shift rounds down for both signs. So 255 and 46
/// with code 7, exactly 75.9, are 75 here and 77 there. The largest difference over all pairs of values is 2,
/// and 3 for signed ones, which are rounded towards 0 from both sides here (tests/render/s3tc_test.cpp).
[[nodiscard]] Image decodeBlocks(const BlockImage& image);

/// The same into existing memory: width * height * depth texels of 4 bytes, without padding.
void decodeBlocks(const BlockImage& image, std::span<std::byte> rgba);

/// Decodes a block to 4 x 4 Rgba8 texels, row by row, as written in the specification; decodeBlocks is tested
/// against it.
void decodeBlock(BlockFormat format, const std::byte* block, std::byte* rgba);

} // namespace texplorer
