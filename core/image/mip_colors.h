#pragma once

#include <array>
#include <cstdint>

namespace texplorer {

/// The opaque colour of a level in the coloured mip set; the eight colours repeat: level 0 red, 1 orange, 2
/// yellow, 3 green, 4 cyan, 5 blue, 6 violet, 7 white.
[[nodiscard]] std::array<std::uint8_t, 4> mipColor(int level);

} // namespace texplorer
