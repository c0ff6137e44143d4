#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace texplorer {

/// The source index (0 … 3) of the first, second, third and fourth byte of a pixel.
using ByteOrder = std::array<std::uint8_t, 4>;

/// Copies `count` pixels of four bytes in another byte order. The areas must not overlap. Uses SSSE3's byte
/// shuffle if the processor has it.
void reorderFourToFour(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order);

/// The same, to pixels of three bytes: the order's fourth entry is ignored.
void reorderFourToThree(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order);

/// Both, byte by byte; the tests compare with it.
void reorderScalar(const std::byte* from, std::byte* to, std::size_t count, const ByteOrder& order,
                   std::size_t components);

} // namespace texplorer
