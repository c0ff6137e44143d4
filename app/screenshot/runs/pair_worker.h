#pragma once

#include "app/screenshot/runs/work_order.h"

namespace texplorer::screenshot {

/// Judges two PNGs of the same name in two folders, or one that is in one of them alone.
[[nodiscard]] WorkAnswer comparePair(const WorkOrder& order);

} // namespace texplorer::screenshot
