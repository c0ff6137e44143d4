#pragma once

#include "texplorer/gl/sampling.h"
#include "texplorer/image/image.h"

namespace texplorer {

/// Returns the part of an image that a texture target uses, the same for every renderer: for 1D the middle
/// row, for 2D and a cube map the middle slice, for 3D everything (a picture is a volume of depth 1). With an
/// even number of rows or slices, the upper one of the two in the middle. An empty image stays empty.
[[nodiscard]] Image imageForTarget(const Image& image, Target target);

} // namespace texplorer
