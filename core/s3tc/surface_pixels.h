#pragma once

#include "core/image/texture_image.h"

namespace texplorer {

/// A surface as pixels, decompressed where it is compressed; rows in the order they have.
[[nodiscard]] Image toImage(Surface surface);

/// Level 0 of face 0 as pixels, bottom row first: what a program wants that just shows the picture.
[[nodiscard]] Image uprightImage(TextureImage texture);

} // namespace texplorer
