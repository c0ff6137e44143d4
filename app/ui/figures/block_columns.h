#pragma once

// The columns of the microscope: the texels, the palette that their indices refer to, and the bits of the
// block.

#include "app/ui/figures/block_microscope.h"

namespace texplorer::ui {

/// The highlighted parts in this frame, and the block.
struct BlockLook {
    BlockFields fields;
    std::array<BlockColor, 4> colors;
    std::array<std::uint8_t, 16> alphas;
    BlockLinks lit;
};

[[nodiscard]] BlockLook lookAt(const BlockMicroscopeState& state);

/// For texels of this size; includes the header above them and to their left.
[[nodiscard]] float blockTexelsWidth(float cell);
[[nodiscard]] float blockTexelsHeight(float cell);
void drawBlockTexels(BlockMicroscopeState& state, const BlockLook& look, float cell);

[[nodiscard]] float blockPaletteWidth();
void drawBlockPalette(BlockMicroscopeState& state, const BlockLook& look);

/// `spread`: the distance of the bits, 1 or more.
[[nodiscard]] float blockBitsWidth(BlockFormat format, float spread);
/// The distance that fits into this much more room than a distance of 1 needs.
[[nodiscard]] float blockBitsSpread(BlockFormat format, float more);
/// The width of all bytes in one line.
[[nodiscard]] float blockHexWidth(BlockFormat format);
/// Fills the height `room` if it is enough, and the width of the column.
void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look, float spread, float room);

} // namespace texplorer::ui
