#pragma once

#include <cstddef>
#include <vector>

namespace texplorer::animation {

/// How long each of `frames` pictures is shown that are `perSecond` apart and last `seconds` together, in
/// units of which a second has `units`: what is rounded is when each begins, so that errors don't add up and
/// the whole length is right to half a unit. At least 1 each.
[[nodiscard]] std::vector<int> durationsOf(std::size_t frames, double perSecond, double seconds, int units);

} // namespace texplorer::animation
