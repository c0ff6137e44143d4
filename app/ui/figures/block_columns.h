#pragma once

// The columns of the microscope: the texels, the colours that their indices mean, and the bits of all that.

#include "app/ui/figures/block_microscope.h"

namespace texplorer::ui {

/// What is lit in this frame, and what the block is.
struct BlockLook {
    BlockFields fields;
    std::array<BlockColor, 4> colors;
    std::array<std::uint8_t, 16> alphas;
    BlockLinks lit;
};

[[nodiscard]] BlockLook lookAt(const BlockMicroscopeState& state);

/// Texels of this side; the header is above them and to their left.
[[nodiscard]] float blockTexelsWidth(float cell);
[[nodiscard]] float blockTexelsHeight(float cell);
void drawBlockTexels(BlockMicroscopeState& state, const BlockLook& look, float cell);

[[nodiscard]] float blockPaletteWidth();
void drawBlockPalette(BlockMicroscopeState& state, const BlockLook& look);

/// `spread`: how far the bits are apart, 1 or more.
[[nodiscard]] float blockBitsWidth(BlockFormat format, float spread);
/// How far they can be apart with so much more room than that of 1.
[[nodiscard]] float blockBitsSpread(BlockFormat format, float more);
/// Of all bytes in one line.
[[nodiscard]] float blockHexWidth(BlockFormat format);
/// As high as `room` where that will do, as wide as the column.
void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look, float spread, float room);

} // namespace texplorer::ui
