#pragma once

#include "core/image/image.h"

namespace texplorer {

/// Turns every row around, left to right, in place. Upside down: flipVertically (core/image/texture_image.h).
void mirror(Image& image);

} // namespace texplorer
