#pragma once

#include <bit>

namespace texplorer {

/// False for extents below 1.
[[nodiscard]] constexpr bool isPowerOfTwo(int extent) {
    return extent > 0 && std::has_single_bit(static_cast<unsigned>(extent));
}

[[nodiscard]] constexpr bool arePowersOfTwo(int width, int height, int depth) {
    return isPowerOfTwo(width) && isPowerOfTwo(height) && isPowerOfTwo(depth);
}

} // namespace texplorer
