#pragma once

// The inner loop of decodeBlocks.

#include "core/gl/block_format.h"

#include <cstddef>

namespace texplorer {

/// Decompresses `count` blocks that lie beside each other into four rows of 4 * count Rgba8 texels, the rows
/// `rowBytes` apart.
using RowDecoder = void (*)(const std::byte* blocks, std::size_t count, std::byte* rgba,
                            std::size_t rowBytes);

/// The decoder in vectors of 16 bytes (SSSE3), or nullptr where this processor has none.
[[nodiscard]] RowDecoder vectorRowDecoder(BlockFormat format);

/// decodeBlock, block by block.
[[nodiscard]] RowDecoder plainRowDecoder(BlockFormat format);

} // namespace texplorer
