#pragma once

#include "core/image/image.h"
#include "core/s3tc/block_image.h"

#include <span>

namespace texplorer {

/// Decompresses to Rgba8, rows in the order of the blocks. Colours of DXT1/3/5: 5 and 6 bits are widened by
/// repeating their top bits; the colours between are (2a + b) / 3 and (a + b) / 2 in integers, rounded down,
/// as libsquish does it; the specification leaves the rounding open. BC4 becomes grey in red, green and blue;
/// BC5 red and green with blue 0; signed values map -1..1 to 0..255. Single-threaded.
///
/// Mesa's llvmpipe rounds what lies between the ends otherwise. Measured on random blocks: its colours differ
/// by at most 1, the alphas of DXT5 and the values of BC4 and BC5 by at most 2, signed ones by at most 3 but
/// for rare blocks where it overflows (tests/render/s3tc_test.cpp).
[[nodiscard]] Image decodeBlocks(const BlockImage& image);

/// The same into memory that is there already: width * height * depth texels of 4 bytes, without padding.
void decodeBlocks(const BlockImage& image, std::span<std::byte> rgba);

/// One block to 4 x 4 Rgba8 texels, row by row: the literal text of the specification, and decodeBlocks'
/// oracle.
void decodeBlock(BlockFormat format, const std::byte* block, std::byte* rgba);

} // namespace texplorer
