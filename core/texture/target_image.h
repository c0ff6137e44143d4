#pragma once

#include "core/gl/sampling.h"
#include "core/image/image.h"

namespace texplorer {

/// The part of an image that a texture target takes, the same for every renderer: a 1D texture the middle
/// row, a 2D texture and a cube map the middle slice, a 3D texture everything (a picture is a volume of depth
/// 1). With an even number of rows or slices the upper of the two middle ones. An empty image stays empty.
[[nodiscard]] Image imageForTarget(const Image& image, Target target);

} // namespace texplorer
