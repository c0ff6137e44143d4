#pragma once

#include "texplorer/compare/comparison.h"

#include <string>

namespace texplorer {

/// Makes Comparison::sentence from the other members.
[[nodiscard]] std::string verdictOn(const Comparison& comparison);

} // namespace texplorer
