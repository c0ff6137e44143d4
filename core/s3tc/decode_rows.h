#pragma once

// The inner loop of decodeBlocks.

#include "texplorer/gl/block_format.h"

#include <cstddef>

namespace texplorer {

/// Decompresses `count` adjacent blocks to four rows of 4 * count Rgba8 texels; the rows are `rowBytes`
/// apart.
using RowDecoder = void (*)(const std::byte* blocks, std::size_t count, std::byte* rgba,
                            std::size_t rowBytes);

/// The decoder with vectors of 16 bytes (SSSE3), or nullptr if the processor has none.
[[nodiscard]] RowDecoder vectorRowDecoder(BlockFormat format);

/// Calls decodeBlock for each block.
[[nodiscard]] RowDecoder plainRowDecoder(BlockFormat format);

} // namespace texplorer
