#pragma once

#include "core/compare/comparison.h"

#include <string>

namespace texplorer {

/// Comparison::sentence of one that has everything else.
[[nodiscard]] std::string verdictOn(const Comparison& comparison);

} // namespace texplorer
