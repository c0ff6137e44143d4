#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/image/image.h"

namespace texplorer {

/// A PNG of the first slice, upright (the bottom row is written last). The same image gives the same bytes.
/// Written fast rather than small: deflate level 1, the Sub filter alone.
[[nodiscard]] Result<Bytes> encodePng(const Image& image);

} // namespace texplorer
