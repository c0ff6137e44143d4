#pragma once

#include "texplorer/base/result.h"
#include "texplorer/image/image.h"

namespace texplorer {

/// Checks that both are Rgba8 pictures of the same size; the error says what they are.
[[nodiscard]] Result<void> checkComparable(const Image& a, const Image& b);

} // namespace texplorer
