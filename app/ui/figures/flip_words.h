#pragma once

#include "core/s3tc/flip_steps.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {

/// What a step does and what there is to see then, a sentence each.
[[nodiscard]] std::vector<std::string> flipSentences(std::span<const FlipStep> steps, std::size_t step);

/// Which rows of texels change places in a block of which so many are turned around.
struct RowPair {
    int first;
    int second;
};
[[nodiscard]] std::span<const RowPair> rowPairs(int rows);

} // namespace texplorer::ui
