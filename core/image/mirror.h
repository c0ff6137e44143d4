#pragma once

#include "texplorer/image/image.h"

namespace texplorer {

/// Reverses every row in place. For upside down, see flipVertically (texplorer/image/texture_image.h).
void mirror(Image& image);

} // namespace texplorer
