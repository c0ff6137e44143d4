#pragma once

#include "core/scene/scene.h"

namespace texplorer {

/// The scene with every parameter at its initial value and every list as long as in `scene`: the same paths
/// lead to the initial values.
[[nodiscard]] Scene initialLike(const Scene& scene);

} // namespace texplorer
