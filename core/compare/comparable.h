#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

namespace texplorer {

/// Checks that both are Rgba8 pictures of the same size; the error says what they are.
[[nodiscard]] Result<void> checkComparable(const Image& a, const Image& b);

} // namespace texplorer
