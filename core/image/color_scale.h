#pragma once

#include <array>
#include <cstdint>

namespace texplorer {

/// A colour for a share of a scale, 0 to 1, opaque: from a dark violet through green to yellow, every step
/// lighter than the one before it, so that it also reads without colours and with any colour blindness. It is
/// viridis (N. Smith and S. van der Walt, 2015), in a line between ten of its colours. Outside of the scale,
/// and of what is not a number, it is as the nearest end.
[[nodiscard]] std::array<std::uint8_t, 4> viridis(float share);

} // namespace texplorer
