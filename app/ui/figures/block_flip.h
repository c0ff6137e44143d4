#pragma once

#include "texplorer/s3tc/flip_steps.h"

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

} // namespace texplorer::ui
