#pragma once

#include "texplorer/s3tc/flip_steps.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {

/// What a step does and what it shows, one sentence each.
[[nodiscard]] std::vector<std::string> flipSentences(std::span<const FlipStep> steps, std::size_t step);

/// Rows of texels that are exchanged in a block when this many rows are flipped.
struct RowPair {
    int first;
    int second;
};
[[nodiscard]] std::span<const RowPair> rowPairs(int rows);

} // namespace texplorer::ui
