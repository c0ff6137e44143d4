#pragma once

#include "texplorer/compare/comparison.h"

namespace texplorer {

/// Makes Comparison::sentence from the other members.
[[nodiscard]] Sentence verdictOn(const Comparison& comparison);

} // namespace texplorer
