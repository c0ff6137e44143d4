#pragma once

#include "texplorer/image/texture_image.h"

namespace texplorer {

/// Returns a surface as pixels, decompressed if needed; the order of rows stays.
[[nodiscard]] Image toImage(Surface surface);

/// Returns level 0 of face 0 as pixels, bottom row first: for programs that only show the picture.
[[nodiscard]] Image uprightImage(TextureImage texture);

} // namespace texplorer
