#pragma once

#include <cstddef>
#include <vector>

namespace texplorer::animation {

/// Returns the duration of each of `frames` pictures at `perSecond` pictures per second that last `seconds`
/// together, in units of 1 / `units` seconds. The start times are rounded, not the durations, so errors do
/// not add up and the total is exact to half a unit. Each duration is at least 1.
[[nodiscard]] std::vector<int> durationsOf(std::size_t frames, double perSecond, double seconds, int units);

} // namespace texplorer::animation
