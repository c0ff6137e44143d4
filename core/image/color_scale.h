#pragma once

#include <array>
#include <cstdint>

namespace texplorer {

/// Returns an opaque colour for a share of 0 to 1: from dark violet through green to yellow. Lightness rises
/// steadily, so the scale works without colours and for the colour-blind. This is viridis (N. Smith and S.
/// van der Walt, 2015), interpolated between ten of its colours. Values outside get the nearest end, NaN the
/// lower one.
[[nodiscard]] std::array<std::uint8_t, 4> viridis(float share);

} // namespace texplorer
