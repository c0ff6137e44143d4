#pragma once

#include "texplorer/image/preparation.h"
#include "texplorer/scene/scene.h"
#include "texplorer/texture/level_plan.h"

namespace texplorer {

/// The extents of a level after a step of the preparation.
[[nodiscard]] PlannedLevel resizedBy(const ImageStep& step, const PlannedLevel& level);

/// A step for a level with these extents. `topFirst`: whether row 0 is the top one.
[[nodiscard]] Operation operationOf(const ImageStep& step, const PlannedLevel& level, bool topFirst,
                                    const Image* other);

} // namespace texplorer
