#pragma once

#include "core/image/image.h"

namespace texplorer {

/// Reverses every row in place. For upside down, see flipVertically (core/image/texture_image.h).
void mirror(Image& image);

} // namespace texplorer
