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

[[nodiscard]] float blockBitsWidth(BlockFormat format);
void drawBlockBits(BlockMicroscopeState& state, const BlockLook& look);

} // namespace texplorer::ui
