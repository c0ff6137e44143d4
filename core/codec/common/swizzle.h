#pragma once

#include <cstddef>

namespace texplorer {

/// Copies `count` pixels of three bytes, with the first and third byte swapped: blue-green-red to
/// red-green-blue. The areas must not overlap. Uses SSSE3's byte shuffle if the processor has it.
void swapRedBlue(const std::byte* from, std::byte* to, std::size_t count);

/// The same, byte by byte; the tests compare with it.
void swapRedBlueScalar(const std::byte* from, std::byte* to, std::size_t count);

/// The same for pixels of four bytes, the fourth of which stays: blue-green-red-alpha to
/// red-green-blue-alpha.
void swapRedBlueAlpha(const std::byte* from, std::byte* to, std::size_t count);
void swapRedBlueAlphaScalar(const std::byte* from, std::byte* to, std::size_t count);

} // namespace texplorer
