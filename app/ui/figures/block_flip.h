#pragma once

#include "texplorer/base/sentence.h"
#include "texplorer/s3tc/block_parts.h"
#include "texplorer/s3tc/flip_steps.h"

#include <span>
#include <vector>

namespace texplorer::ui {

struct BlockFlipState {
    BlockFormat format = BlockFormat::Dxt1Alpha;
    int height = 8;
    std::size_t step = 0;

    // The last inputs and their result.
    std::vector<FlipStep> steps{};
    BlockFormat stepsFormat = BlockFormat::Dxt1Alpha;
    int stepsHeight = 0;
};

void drawBlockFlip(BlockFlipState& state);

/// What a step does and what it shows, one sentence each.
[[nodiscard]] std::vector<Sentence> flipSentences(std::span<const FlipStep> steps, std::size_t step);

/// A picture of one block's width with distinguishable rows: each has its own colour, and in DXT3 and DXT5 an
/// alpha that differs from those of the rows around it. This includes rows of the last block beyond the
/// height. For heights up to 12.
[[nodiscard]] BlockImage stripedBlocks(BlockFormat format, int height);

/// A block of any picture.
[[nodiscard]] BlockBytes blockAt(const BlockImage& image, int blockX, int blockY);

/// The row of `original` that is at a texel row of a block row of `image`; -1: none.
[[nodiscard]] int stripeAt(const BlockImage& image, const BlockImage& original, int row);

} // namespace texplorer::ui
