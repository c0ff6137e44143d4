#pragma once

#include "texplorer/scene/scene.h"

namespace texplorer {

/// Returns the scene with every parameter at its initial value and every list as long as in `scene`, so that
/// the same paths exist.
[[nodiscard]] Scene initialLike(const Scene& scene);

} // namespace texplorer
