#pragma once

#include "texplorer/s3tc/flip_steps.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::ui {

/// What a step does and what it shows, one sentence each.
[[nodiscard]] std::vector<std::string> flipSentences(std::span<const FlipStep> steps, std::size_t step);

} // namespace texplorer::ui
