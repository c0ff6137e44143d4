#pragma once

#include "texplorer/gl/environment.h"
#include "texplorer/image/image.h"

namespace texplorer::view {

/// The texture source colours of an image (OpenGL 2.1, tables 3.15 and 3.20) as Rgba8, rows in the same
/// order. For a context that has only RGBA formats.
[[nodiscard]] Image asRgba8(const Image& image, BaseFormat format);

} // namespace texplorer::view
