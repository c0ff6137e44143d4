#pragma once

#include "core/base/result.h"
#include "core/image/image.h"

namespace texplorer {

/// Two Rgba8 pictures of the same size, or an error that says what they are.
[[nodiscard]] Result<void> checkComparable(const Image& a, const Image& b);

} // namespace texplorer
