#pragma once

#include "core/image/image.h"

namespace texplorer {

/// The colours of an Rgba8 image without its alpha, as Rgb8. An image of another format is returned as it is.
[[nodiscard]] Image withoutAlpha(Image image);

} // namespace texplorer
